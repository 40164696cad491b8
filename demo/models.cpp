#include "models.hpp"

#include <system_error>

namespace nacre::demo {

std::filesystem::path shippedModel()
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share/nacre/models/shell.glb";
    if (fs::exists(installed, ignored)) return installed;
    return NACRE_DEMO_MODELS "/shell.glb";
}

}  // namespace nacre::demo
