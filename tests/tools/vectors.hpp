#pragma once

#include <array>
#include <string>
#include <vector>

#include <nacre/evaluate.hpp>
#include <nacre/material.hpp>

#include "csv_table.hpp"
#include "gpu_evaluator.hpp"

namespace nacre::test {

/// An evaluation as a row of the reference vectors states it; all vectors as they stand in the row.
struct Case {
    Material material;
    Surface surface;
    glm::dvec3 light, view;
};

/// The columns that make a Case, in the vectors' order; physical: and what lies below the layer.
const std::vector<std::string>& inputColumns(Quality quality = Quality::paper);

/// The result columns: the names of Evaluation's first six members, three channels each.
const std::vector<std::string>& resultColumns();

/// All rows; other columns than inputColumns() are passed over. Errors: a column is missing, a cell is no
/// number, a material that does not validate, each with its row.
Result<std::vector<Case>> readCases(const CsvTable& table, Quality quality = Quality::paper);

/// In double precision. Light and view are normalised here, the normals where they enter.
Result<Evaluation> evaluate(const Case& one, const FringeTable* fringeTable = nullptr);

/// As the shader gets it: normalised in double precision, then rounded.
Result<GpuInput> gpuInput(const Case& one);

/// The results in the order of resultColumns(). Either kind: Evaluation or GpuOutput.
std::array<double, 18> results(const Evaluation& evaluation);
std::array<double, 18> results(const Case& one, const GpuOutput& output);

}  // namespace nacre::test
