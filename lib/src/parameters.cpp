#include <nacre/parameters.hpp>

namespace nacre {

// Why these bounds: indices from X-ray-like 0.1 to semiconductors; wavelengths wider than the eye's
// 380-780 nm, so that an infrared or ultraviolet false colour can be made; 1 mm is where a film has long
// ceased to interfere; exponents to 1e6, a lobe of 0.1 degrees, narrower than the sun:
// all the bounds that the accuracy figures cover. Weights are free above, for stylised looks.
const std::array<Parameter, 15>& parameters() noexcept
{
    static const std::array<Parameter, 15> table{{
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
    }};
    return table;
}

const std::array<std::string_view, 4>& lowerNormalNames() noexcept
{
    static const std::array<std::string_view, 4> names{{"parallel", "constant", "independent", "gradient"}};
    return names;
}

}  // namespace nacre
