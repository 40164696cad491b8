#include <nacre/parameters.hpp>

#include <type_traits>

namespace nacre {
namespace {

template <class Member>
constexpr bool isChoice = std::is_enum_v<std::decay_t<decltype(std::declval<Material&>().*std::declval<Member>())>>;

template <std::size_t N>
std::vector<std::string_view> list(const std::array<std::string_view, N>& names)
{
    return {names.begin(), names.end()};
}

}  // namespace

// Why these bounds: indices from X-ray-like 0.1 to semiconductors; wavelengths wider than the eye's
// 380-780 nm, so that an infrared or ultraviolet false colour can be made; 1 mm is where a film has long
// ceased to interfere; exponents to 1e6, a lobe of 0.1 degrees, narrower than the sun:
// all the bounds that the accuracy figures cover. Weights are free above, for stylised looks. Below the
// layer n from silver's 0.04 down to 0.01, and both n and k up to 100, beyond every metal in visible light.
const std::array<Parameter, 22>& parameters() noexcept
{
    static const std::array<Parameter, 22> table{{
        {"quality", "", "", 0.0, 1.0, "--quality",
         "paper: the model as printed, stylised and cheap. physical: the same lobes with a real film between them.", &Material::quality},
        {"ior", "r1", "", 0.1, 10.0, "--ior",
         "Index of the layer per channel. Farther from the outside index: brighter, stronger fringes. Unequal: tilted boundaries split the highlight into colours.",
         &Material::ior},
        {"iorOutside", "r0", "", 0.1, 10.0, "--ior-outside",
         "Index outside the layer: 1 in air, 1.33 under water.", &Material::iorOutside},
        {"wavelengthNm", "λ", "nm", 200.0, 2000.0, "--wavelengths",
         "Wavelength that each channel stands for.", &Material::wavelengthNm},
        {"thicknessLeastNm", "d", "nm", 0.0, 1.0e6, "--thickness",
         "Least thickness of the layer. Thin: warm. Thicker: blue, then green, then pastel orders.",
         &Material::thicknessLeastNm},
        {"thicknessMostNm", "d", "nm", 0.0, 1.0e6, "--thickness",
         "Greatest thickness. The wider the range, the more bands.", &Material::thicknessMostNm},
        {"noiseFrequency", "", "1/unit", 0.0, 1.0e4, "--noise-frequency",
         "Features of the thickness per unit of the object's space.", &Material::noiseFrequency},
        {"noiseOctaves", "", "", 0.0, 8.0, "--noise-octaves",
         "Layers of finer detail in the thickness; 0: constant, the middle of the bounds.", &Material::noiseOctaves},
        {"noiseSeed", "", "", 0.0, 1.0e6, "--noise-seed", "Another number, another pattern.", &Material::noiseSeed},
        {"lowerNormal", "n1", "", 0.0, 3.0, "--lower-normal",
         "How the lower boundary lies to the upper one.", &Material::lowerNormal},
        {"deviationDegrees", "", "°", 0.0, 180.0, "--deviation",
         "Angle between the boundaries: moves the second highlight and, with unequal indices, splits its colours.",
         &Material::deviationDegrees},
        {"azimuthDegrees", "", "°", -360.0, 360.0, "--azimuth",
         "Direction of the tilt, from the surface's tangent.", &Material::azimuthDegrees},
        {"upperExponent", "e0", "", 0.0, 1.0e6, "--exponents",
         "Phong exponent of the upper boundary: higher is smoother, its highlight smaller.", &Material::upperExponent},
        {"lowerExponent", "e1", "", 0.0, 1.0e6, "--exponents",
         "Phong exponent of the lower boundary. Very high with tilt: the colours no longer blend.",
         &Material::lowerExponent},
        {"specularWeight", "", "", 0.0, 1.0e3, "--weights", "Share of the specular part.", &Material::specularWeight},
        {"diffuseWeight", "", "", 0.0, 1.0e3, "--weights", "Share of the diffuse part.", &Material::diffuseWeight},
        {"substrate", "", "", 0.0, 2.0, "--substrate", "physical: what lies below the layer, and which of the next three say so.",
         &Material::substrate},
        {"substrateIndex", "n", "", 0.01, 100.0, "--substrate-index",
         "physical: index below the layer per channel. Near the layer's: no fringes. A metal's real part.", &Material::substrateIndex},
        {"substrateAbsorption", "k", "", 0.0, 100.0, "--substrate-absorption",
         "physical: a metal's absorption index per channel. Higher: brighter, and the fringes shift.", &Material::substrateAbsorption},
        {"substrateF0", "", "", 0.0, 1.0, "--substrate-f0",
         "physical: linear colour that the bare object reflects at normal incidence, in place of an index.", &Material::substrateF0},
        {"lobes", "", "", 0.0, 1.0, "--lobes", "physical: whether a lobe's height follows from its width.", &Material::lobes},
        {"diffuseAlbedo", "", "", 0.0, 1.0, "--diffuse-albedo", "physical: linear colour of the diffuse part.", &Material::diffuseAlbedo},
    }};
    return table;
}

const std::array<std::string_view, 4>& lowerNormalNames() noexcept
{
    static const std::array<std::string_view, 4> names{{"parallel", "constant", "independent", "gradient"}};
    return names;
}

const std::array<std::string_view, 2>& qualityNames() noexcept
{
    static const std::array<std::string_view, 2> names{{"paper", "physical"}};
    return names;
}

const std::array<std::string_view, 3>& substrateNames() noexcept
{
    static const std::array<std::string_view, 3> names{{"dielectric", "metal", "f0"}};
    return names;
}

const std::array<std::string_view, 2>& lobesNames() noexcept
{
    static const std::array<std::string_view, 2> names{{"paper", "normalised"}};
    return names;
}

const std::vector<std::string_view>& choices(const Parameter& parameter)
{
    static const std::vector<std::string_view> none, lowerNormal = list(lowerNormalNames()), quality = list(qualityNames()),
                                                     substrate = list(substrateNames()), lobes = list(lobesNames());
    if (std::holds_alternative<LowerNormal Material::*>(parameter.member)) return lowerNormal;
    if (std::holds_alternative<Quality Material::*>(parameter.member)) return quality;
    if (std::holds_alternative<Substrate Material::*>(parameter.member)) return substrate;
    if (std::holds_alternative<Lobes Material::*>(parameter.member)) return lobes;
    return none;
}

int choice(const Material& material, const Parameter& parameter) noexcept
{
    return std::visit(
        [&](auto member) {
            if constexpr (isChoice<decltype(member)>) return static_cast<int>(material.*member);
            else return -1;
        },
        parameter.member);
}

void setChoice(Material& material, const Parameter& parameter, int value) noexcept
{
    std::visit(
        [&](auto member) {
            if constexpr (isChoice<decltype(member)>) material.*member = static_cast<std::decay_t<decltype(material.*member)>>(value);
        },
        parameter.member);
}

}  // namespace nacre
