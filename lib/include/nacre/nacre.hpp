#pragma once

// Everything: a layered material after Granier & Heidrich, "A Simple Layered RGB BRDF Model" (2003).

#include <nacre/block.hpp>
#include <nacre/evaluate.hpp>
#include <nacre/feature_names.hpp>
#include <nacre/features.hpp>
#include <nacre/fringe_table.hpp>
#include <nacre/glsl.hpp>
#include <nacre/lights.hpp>
#include <nacre/material.hpp>
#include <nacre/parameters.hpp>
#include <nacre/presets.hpp>
#include <nacre/result.hpp>
#include <nacre/uniforms.hpp>
#include <nacre/validate.hpp>
