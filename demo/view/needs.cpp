#include "needs.hpp"

#include <nacre/features.hpp>
#include <nacre/glsl.hpp>

namespace nacre::demo {

Result<Needs> needsOf(const Material& material)
{
    Result<Features> features = featuresOf(material);
    if (!features) return features.error();
    GlslOptions options;
    options.features = *features;
    options.isResolved = true;
    Result<std::string> text = glsl(options);
    if (!text) return text.error();
    return Needs{describe(*features), *std::move(text)};
}

}  // namespace nacre::demo
