#include "naive_forms.hpp"

#include <nacre/glsl.hpp>

namespace nacre::test {
namespace {

const char* const direction = R"(
vec3 naive_direction(vec3 a) { return normalize(a); }
#define nacre_direction naive_direction
)";

const char* const index = R"(
vec3 naive_refractedCosineSquared(vec3 etaSquared, vec3 oneMinusEtaSquared, float cosTheta)
{
    return 1.0 - etaSquared * (1.0 - cosTheta * cosTheta);
}
#define nacre_refractedCosineSquared naive_refractedCosineSquared
)";

const char* const transmittance = R"(
float naive_transmittanceShape(float c) { return 1.0 - pow(1.0 - c, 5.0); }
vec3 naive_transmittanceShape(vec3 c) { return 1.0 - pow(1.0 - c, vec3(5.0)); }
#define nacre_transmittanceShape naive_transmittanceShape
)";

// <l, v> = |l + v|²/2 - 1.
const char* const lobe = R"(
float naive_upperLobeOneMinus(vec3 upperNormal, vec3 halfVector, float cosThetaI, float cosThetaO)
{
    return 1.0 - (2.0 * cosThetaI * cosThetaO - (0.5 * dot(halfVector, halfVector) - 1.0));
}
#define nacre_upperLobeOneMinus naive_upperLobeOneMinus
)";

const char* const power = R"(
float naive_powerOneMinus(float u, float exponent) { return pow(max(1.0 - u, 0.0), exponent); }
vec3 naive_powerOneMinus(vec3 u, float exponent) { return pow(max(1.0 - u, 0.0), vec3(exponent)); }
#define nacre_powerOneMinus naive_powerOneMinus
)";

const char* const cosine = R"(
vec3 naive_cosPhase(vec3 cycles) { return cos(3.14159265 * cycles); }
#define nacre_cosPhase naive_cosPhase
)";

const char* const interference = R"(
vec3 naive_interference(vec3 sqrtR, vec3 sqrtT, vec3 cosPhase)
{
    vec3 R = sqrtR * sqrtR, T = sqrtT * sqrtT;
    return R + T + 2.0 * (2.0 * cosPhase * cosPhase - 1.0) * sqrt(R * T);
}
#define nacre_interference naive_interference
)";

}  // namespace

const std::vector<NaiveForm>& naiveForms()
{
    static const std::vector<NaiveForm> forms{
        {"direction", "normalize(), for every normal", direction, false},
        {"index", "1 - eta² subtracted in the shader", index, false},
        {"transmittance", "1 - pow(1 - c, 5)", transmittance, false},
        {"lobe", "the upper lobe's cosine from dot products", lobe, false},
        {"power", "pow() of the lobe's cosine", power, false},
        {"split-phase", "the path as one product", "#define NACRE_SPLIT_PHASE 0\n", true},
        {"cosine", "the built-in cosine of the phase", cosine, false},
        {"interference", "R + T + 2 cos sqrt(R T)", interference, false},
    };
    return forms;
}

Result<std::string> withNaiveForm(const std::string& library, const std::string& name)
{
    std::string names;
    for (const NaiveForm& form : naiveForms()) {
        names += (names.empty() ? "" : ", ") + form.name;
        if (form.name != name) continue;
        if (form.isSwitch) {
            // The features' own line for the switch gives way.
            const std::string define = form.text.substr(0, form.text.rfind(' ') + 1);
            const std::size_t at = library.find(define);
            if (at == std::string::npos) return Error{"naive forms: the library's text has no " + define};
            return library.substr(0, at) + form.text + library.substr(library.find('\n', at) + 1);
        }
        // All that uses the function stands in nacre_layered.glsl, or behind it.
        std::size_t source = 1;
        for (const GlslFile& file : glslFiles()) {
            if (file.name == "nacre_layered.glsl") break;
            ++source;
        }
        const std::size_t at = library.find("#line 1 " + std::to_string(source) + '\n');
        if (at == std::string::npos) return Error{"naive forms: the library's text has no nacre_layered.glsl"};
        return library.substr(0, at) + form.text + library.substr(at);
    }
    return Error{"expected a naive form, one of " + names + ", got '" + name + "'"};
}

}  // namespace nacre::test
