#pragma once

#include <gtest/gtest.h>

#include "gl/context.hpp"

namespace nacre::test {

/// A context that lives as long as the test program; NACRE_CONTEXT chooses its kind. A machine without
/// one fails: the results that the tests are for would be missing.
inline const demo::Context& context()
{
    static const Result<demo::Context> instance = [] {
        Result<demo::Context> created = demo::Context::create();
        if (!created) {
            std::fprintf(stderr, "%s\n", created.error().message.c_str());
            std::abort();
        }
        std::printf("OpenGL by %s: %s\n", created->kind().c_str(), created->renderer().c_str());
        return created;
    }();
    return *instance;
}

}  // namespace nacre::test
