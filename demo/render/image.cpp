#include "image.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>

#include "output_file.hpp"

namespace nacre::demo {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageBuf;
using OIIO::ImageBufAlgo::colorconvert;

ImageBuf buffer(const Image& image)
{
    const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
    return ImageBuf(spec, const_cast<float*>(image.pixels.data()));  // wraps; only read from
}

Image image(const ImageBuf& buffer)
{
    Image result{buffer.spec().width, buffer.spec().height, {}};
    result.pixels.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height) * 3);
    buffer.get_pixels(buffer.roi(), OIIO::TypeDesc::FLOAT, result.pixels.data());
    return result;
}

}  // namespace

Outcome checkWritable(const fs::path& file)
{
    const fs::path ending = file.extension();
    if (ending != ".png" && ending != ".exr") return cannotWrite(file, "expected a name that ends in .png or .exr");
    return checkPlace(file);
}

Outcome writeImage(const Image& image, const fs::path& file)
{
    Outcome writable = checkWritable(file);
    if (!writable) return writable;

    ImageBuf pixels = buffer(image);
    const bool isPng = file.extension() == ".png";
    if (isPng) {
        pixels = colorconvert(pixels, "linear", "sRGB");
        if (pixels.has_error()) return cannotWrite(file, pixels.geterror());
    }
    // Encoded in memory: the library's PNG writer does not notice a full disk.
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    pixels.set_write_ioproxy(&memory);
    if (!pixels.write(file.string(), isPng ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT)) return cannotWrite(file, pixels.geterror());
    return replaceFile(file, bytes.data(), bytes.size());
}

Image shrink(const Image& source, int factor)
{
    if (factor == 1) return source;
    const OIIO::ROI roi(0, source.width / factor, 0, source.height / factor, 0, 1, 0, 3);
    return image(OIIO::ImageBufAlgo::resize(buffer(source), "box", 1.0F, roi));
}

Image contactSheet(const std::vector<LabelledImage>& images, int columns)
{
    const int width = images.front().image.width, height = images.front().image.height;
    const int gap = std::max(width / 40, 4), caption = std::max(width / 12, 12);
    const int rows = (static_cast<int>(images.size()) + columns - 1) / columns;
    ImageBuf sheet(OIIO::ImageSpec(gap + columns * (width + gap), gap + rows * (height + caption + gap), 3, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::fill(sheet, {0.75F, 0.75F, 0.75F});
    for (std::size_t i = 0; i < images.size(); ++i) {
        const int x = gap + static_cast<int>(i) % columns * (width + gap);
        const int y = gap + static_cast<int>(i) / columns * (height + caption + gap);
        OIIO::ImageBufAlgo::paste(sheet, x, y, 0, 0, buffer(images[i].image));
        // Where OpenImageIO finds no font the sheet goes without captions.
        OIIO::ImageBufAlgo::render_text(sheet, x + width / 2, y + height + caption / 2, images[i].label, caption * 5 / 9, "DejaVuSans",
                                        {0.02F, 0.02F, 0.02F}, OIIO::ImageBufAlgo::TextAlignX::Center,
                                        OIIO::ImageBufAlgo::TextAlignY::Center);
    }
    return image(sheet);
}

}  // namespace nacre::demo
