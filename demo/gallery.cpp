#include "gallery.hpp"

#include <string>
#include <vector>

#include <nacre/presets.hpp>

namespace nacre::demo {

Outcome writeGallery(const Renderer& renderer, const Viewpoint& viewpoint, const std::filesystem::path& directory,
                     int width, int height, const std::function<void(std::size_t, std::size_t)>& progress)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) return Error{"cannot make the directory '" + directory.string() + "': " + error.message()};

    const std::size_t total = presets().size() + 1;
    std::vector<LabelledImage> pictures;
    for (const Preset& preset : presets()) {
        Result<Image> picture = renderer.render(preset.material, width, height, viewpoint);
        if (!picture) return picture.error();
        Outcome written = writeImage(*picture, directory / (std::string(preset.name) + ".png"));
        if (!written) return written;
        pictures.push_back({std::move(*picture), std::string(preset.figure)});
        progress(pictures.size(), total);
    }
    Outcome written = writeImage(contactSheet(pictures, 3), directory / "contact-sheet.png");
    if (written) progress(total, total);
    return written;
}

}  // namespace nacre::demo
