#include <nacre/uniforms.hpp>

#include <algorithm>
#include <cstring>
#include <string>

namespace nacre {
namespace {

constexpr unsigned int linkStatus = 0x8B82;  // GL_LINK_STATUS

// The host's table of functions has one type for all; what each really is stands at its use.
template <class Function>
bool load(GetProcAddress getProcAddress, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(getProcAddress(name));
    return function != nullptr;
}

Error missing(const char* name)
{
    return {std::string("nacre::Uniforms::locate(): the host's GetProcAddress does not know ") + name +
            "; is a context of OpenGL 2.0 or OpenGL ES 2.0 current?"};
}

}  // namespace

const std::array<BlockMember, 34>& blockMembers() noexcept
{
    using Type = BlockMember::Type;
    static const std::array<BlockMember, 34> members{{
        {"nacre_u_eta", Type::vec3, offsetof(Block, eta)},
        {"nacre_u_upperExponent", Type::real, offsetof(Block, upperExponent)},
        {"nacre_u_etaSquared", Type::vec3, offsetof(Block, etaSquared)},
        {"nacre_u_lowerExponent", Type::real, offsetof(Block, lowerExponent)},
        {"nacre_u_oneMinusEtaSquared", Type::vec3, offsetof(Block, oneMinusEtaSquared)},
        {"nacre_u_specularWeight", Type::real, offsetof(Block, specularWeight)},
        {"nacre_u_normalReflectance", Type::vec3, offsetof(Block, normalReflectance)},
        {"nacre_u_diffuseWeight", Type::real, offsetof(Block, diffuseWeight)},
        {"nacre_u_cyclesPerUm", Type::vec3, offsetof(Block, cyclesPerUm)},
        {"nacre_u_thicknessLeastUm", Type::real, offsetof(Block, thicknessLeastUm)},
        {"nacre_u_cyclesPerUmTail", Type::vec3, offsetof(Block, cyclesPerUmTail)},
        {"nacre_u_thicknessMostUm", Type::real, offsetof(Block, thicknessMostUm)},
        {"nacre_u_diffuseFringe", Type::vec3, offsetof(Block, diffuseFringe)},
        {"nacre_u_noiseFrequency", Type::real, offsetof(Block, noiseFrequency)},
        {"nacre_u_deviationCos", Type::real, offsetof(Block, deviationCos)},
        {"nacre_u_deviationSin", Type::real, offsetof(Block, deviationSin)},
        {"nacre_u_azimuthCos", Type::real, offsetof(Block, azimuthCos)},
        {"nacre_u_azimuthSin", Type::real, offsetof(Block, azimuthSin)},
        {"nacre_u_noiseOctaves", Type::integer, offsetof(Block, noiseOctaves)},
        {"nacre_u_noiseSeed", Type::integer, offsetof(Block, noiseSeed)},
        {"nacre_u_lowerNormal", Type::integer, offsetof(Block, lowerNormal)},
        {"nacre_u_quality", Type::integer, offsetof(Block, quality)},
        {"nacre_u_index", Type::vec3, offsetof(Block, index)},
        {"nacre_u_upperScale", Type::real, offsetof(Block, upperScale)},
        {"nacre_u_substrateReal", Type::vec3, offsetof(Block, substrateReal)},
        {"nacre_u_lowerScale", Type::real, offsetof(Block, lowerScale)},
        {"nacre_u_substrateImaginary", Type::vec3, offsetof(Block, substrateImaginary)},
        {"nacre_u_substrate", Type::integer, offsetof(Block, substrate)},
        {"nacre_u_diffuseAlbedo", Type::vec3, offsetof(Block, diffuseAlbedo)},
        {"nacre_u_lobes", Type::integer, offsetof(Block, lobes)},
        {"nacre_u_diffuse", Type::vec3, offsetof(Block, diffuse)},
        {"nacre_u_thicknessUm", Type::real, offsetof(Block, thicknessUm)},
        {"nacre_u_pathHead", Type::vec3, offsetof(Block, pathHead)},
        {"nacre_u_pathTail", Type::vec3, offsetof(Block, pathTail)},
    }};
    return members;
}

Result<Uniforms> Uniforms::locate(GetProcAddress getProcAddress, unsigned int program)
{
    if (!getProcAddress) return Error{"nacre::Uniforms::locate(): expected a GetProcAddress function, got null"};

    unsigned char(NACRE_GL_CALL * isProgram)(unsigned int) = nullptr;
    void(NACRE_GL_CALL * getProgramiv)(unsigned int, unsigned int, int*) = nullptr;
    int(NACRE_GL_CALL * getUniformLocation)(unsigned int, const char*) = nullptr;
    Uniforms uniforms;
    if (!load(getProcAddress, "glIsProgram", isProgram)) return missing("glIsProgram");
    if (!load(getProcAddress, "glGetProgramiv", getProgramiv)) return missing("glGetProgramiv");
    if (!load(getProcAddress, "glGetUniformLocation", getUniformLocation)) return missing("glGetUniformLocation");
    if (!load(getProcAddress, "glUniform1f", uniforms.uniform1f_)) return missing("glUniform1f");
    if (!load(getProcAddress, "glUniform1i", uniforms.uniform1i_)) return missing("glUniform1i");
    if (!load(getProcAddress, "glUniform3fv", uniforms.uniform3fv_)) return missing("glUniform3fv");

    const std::string got = ", got " + std::to_string(program);
    if (!isProgram(program)) return Error{"nacre::Uniforms::locate(): expected the name of a program" + got};
    int linked = 0;
    getProgramiv(program, linkStatus, &linked);
    if (!linked) return Error{"nacre::Uniforms::locate(): expected a linked program" + got};

    const auto& members = blockMembers();
    std::transform(members.begin(), members.end(), uniforms.locations_.begin(),
                   [&](const BlockMember& member) { return getUniformLocation(program, member.uniform); });
    const auto isFound = [](int location) { return location >= 0; };
    if (std::none_of(uniforms.locations_.begin(), uniforms.locations_.end(), isFound)) {
        return Error{"nacre::Uniforms::locate(): expected a program with nacre's plain uniforms" + got +
                     ", which has none; was it assembled with GlslUniforms::plain?"};
    }
    return uniforms;
}

void Uniforms::set(const Block& block) const noexcept
{
    const auto* bytes = reinterpret_cast<const unsigned char*>(&block);
    const auto& members = blockMembers();
    for (std::size_t i = 0; i < members.size(); ++i) {
        const unsigned char* at = bytes + members[i].offset;
        switch (members[i].type) {
        case BlockMember::Type::vec3: {
            float value[3];
            std::memcpy(value, at, sizeof value);
            uniform3fv_(locations_[i], 1, value);
            break;
        }
        case BlockMember::Type::real: {
            float value = 0.0F;
            std::memcpy(&value, at, sizeof value);
            uniform1f_(locations_[i], value);
            break;
        }
        case BlockMember::Type::integer: {
            std::int32_t value = 0;
            std::memcpy(&value, at, sizeof value);
            uniform1i_(locations_[i], value);
            break;
        }
        }
    }
}

}  // namespace nacre
