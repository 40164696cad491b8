#include "complete_shader.hpp"

namespace nacre::demo {
namespace {

// What `main` needs beside the library's functions.
class Interface {
public:
    explicit Interface(const GlslOptions& options) : options_(options) {}

    void input(const std::string& declaration, const char* comment)
    {
        text_ += location(inputs_++) + (declaration.rfind("int ", 0) == 0 ? "flat in " : "in ") + declaration + ";  // " + comment + '\n';
    }
    void sampler(const char* name, const char* comment)
    {
        if (options_.vulkan) text_ += "layout(set = 0, binding = " + std::to_string(bindings_++) + ") ";
        text_ += std::string("uniform ") + (options_.es ? "highp " : "") + "sampler2D " + name + ";  // " + comment + '\n';
    }
    std::string text() const { return text_ + "layout(location = 0) out vec4 nacre_outColour;  // linear\n"; }

private:
    std::string location(int index) const
    {
        return options_.vulkan ? "layout(location = " + std::to_string(index) + ") " : std::string();
    }

    const GlslOptions& options_;
    std::string text_;
    int inputs_ = 0, bindings_ = 2;
};

bool hasTangent(const Features& f)
{
    return f.lowerNormals == LowerNormals::constant || f.lowerNormals == LowerNormals::any;
}

bool hasObjectPosition(const Features& f)
{
    const bool leansByNoise = f.lowerNormals == LowerNormals::independent || f.lowerNormals == LowerNormals::gradient || f.lowerNormals == LowerNormals::any;
    return f.thickness == ThicknessSource::noise || (leansByNoise && f.thickness != ThicknessSource::map);
}

std::string declarations(const GlslOptions& options, const Features& f)
{
    const bool hasMap = f.thickness == ThicknessSource::map;
    Interface interface(options);
    interface.input("vec3 nacre_inPosition", "in the space of the lights");
    interface.input("vec3 nacre_inNormal", "any length");
    interface.input("vec3 nacre_inToViewer", "from the position, any length");
    if (hasTangent(f)) interface.input("vec4 nacre_inTangent", "w: its handedness, as in glTF");
    if (hasObjectPosition(f)) interface.input("vec3 nacre_inObjectPosition", "in the object's own space, where the noise lives");
    if (hasMap) interface.input("vec2 nacre_inMapPosition", "where to look up the maps");
    if (f.materials > 1) interface.input("int nacre_inMaterial", "index of the block's materials");
    if (f.fringes != Fringes::samplerFree) interface.sampler("nacre_fringeTable", "nacre::FringeTable: linear, clamped");
    if (hasMap) interface.sampler("nacre_thicknessMap", "red: um");
    if (hasMap && f.lowerNormals == LowerNormals::any) interface.sampler("nacre_lowerNormalMap", "in tangent space, 0 to 1");
    return interface.text();
}

std::string surface(const Features& f)
{
    if (f.thickness == ThicknessSource::map) {
        const std::string thickness = "texture(nacre_thicknessMap, nacre_inMapPosition).r);\n";
        if (f.lowerNormals == LowerNormals::parallel) return "    nacre_Surface s = nacre_Surface(normal, normal, " + thickness;
        return "    vec3 lean = 2.0 * texture(nacre_lowerNormalMap, nacre_inMapPosition).xyz - 1.0;\n"
               "    vec3 across = cross(normal, nacre_inTangent.xyz) * nacre_inTangent.w;\n"
               "    vec3 lower = nacre_inTangent.xyz * lean.x + across * lean.y + normal * lean.z;\n"
               "    nacre_Surface s = nacre_Surface(normal, lower, " +
               thickness;
    }
    return "    // The matrix turns the object's own space to that of the normal.\n"
           "    nacre_Surface s = nacre_surface(m, normal, " +
           std::string(hasTangent(f) ? "nacre_inTangent" : "vec4(0.0)") + ", " +
           (hasObjectPosition(f) ? "nacre_inObjectPosition" : "vec3(0.0)") + ", mat3(1.0));\n";
}

std::string mainFunction(const Features& f)
{
    const std::string table = f.fringes == Fringes::samplerFree ? "" : ", nacre_fringeTable";
    return "\nvoid main()\n{\n    nacre_Material m = " + std::string(f.materials > 1 ? "nacre_material(nacre_inMaterial)" : "nacre_materialFromUniforms()") +
           ";\n"
           "    vec3 normal = gl_FrontFacing ? nacre_inNormal : -nacre_inNormal;  // both sides of a sheet are seen\n" +
           surface(f) + "    nacre_Shading w = nacre_shading(m, s, normalize(nacre_inToViewer)" + table +
           ");\n"
           "    vec3 colour = vec3(0.0);\n"
           "    for (int i = 0; i < nacre_lightCount(); ++i) {\n"
           "        nacre_Incidence light = nacre_incidence(nacre_lightSource(i), nacre_inPosition);\n"
           "        colour += light.radiance * nacre_shade(m, w, light.direction" +
           table +
           ");\n"
           "    }\n"
           "    nacre_outColour = vec4(colour, 1.0);\n}\n";
}

}  // namespace

Result<std::string> completeShader(GlslOptions options)
{
    options.lights = true;
    Result<std::string> library = glsl(options);
    if (!library) return library;
    const Features f = canonical(options.features);
    return *library + '\n' + declarations(options, f) + mainFunction(f);
}

}  // namespace nacre::demo
