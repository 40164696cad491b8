#include <nacre/lights.hpp>

#include <cstring>
#include <string>

#include "model/lights.hpp"
#include "number_text.hpp"

namespace nacre {
namespace {

// So bright at most, and so far away, that no float32 product in the shader overflows.
constexpr double brightest = 1e9, farthest = 1e12;

// The first fault that is found; builds no text unless there is one.
class Check {
public:
    void inRange(const char* name, double least, double most, double value)
    {
        if (value >= least && value <= most) return;  // false for NaN
        say("expected " + text(least) + " <= " + name + " <= " + text(most) + ", got " + text(value));
    }
    void say(const std::string& fault)
    {
        if (fault_.empty()) fault_ = fault;
    }
    const std::string& fault() const { return fault_; }

private:
    std::string fault_;
};

void checkPlace(Check& check, const LightSource& light)
{
    check.inRange("position.x", -farthest, farthest, light.position.x);
    check.inRange("position.y", -farthest, farthest, light.position.y);
    check.inRange("position.z", -farthest, farthest, light.position.z);
    check.inRange("range", 0.0, farthest, light.range);
}

void checkDirection(Check& check, const LightSource& light)
{
    const glm::dvec3 d = light.direction;
    if (model::direction(d) != glm::dvec3(0.0)) return;
    check.say("expected a direction of a length other than 0, got " + text(d.x) + ',' + text(d.y) + ',' + text(d.z));
}

void checkCone(Check& check, const LightSource& light)
{
    check.inRange("innerConeDegrees", 0.0, 90.0, light.innerConeDegrees);
    check.inRange("outerConeDegrees", 0.0, 90.0, light.outerConeDegrees);
    if (light.innerConeDegrees < light.outerConeDegrees) return;
    check.say("expected innerConeDegrees < outerConeDegrees (" + text(light.outerConeDegrees) + "), got " + text(light.innerConeDegrees));
}

std::string faultOf(const LightSource& light)
{
    Check check;
    check.inRange("kind", 0.0, 2.0, static_cast<double>(light.kind));
    check.inRange("colour.r", 0.0, brightest, light.colour.r);
    check.inRange("colour.g", 0.0, brightest, light.colour.g);
    check.inRange("colour.b", 0.0, brightest, light.colour.b);
    check.inRange("intensity", 0.0, brightest, light.intensity);
    if (light.kind != LightKind::directional) checkPlace(check, light);
    if (light.kind != LightKind::point) checkDirection(check, light);
    if (light.kind == LightKind::spot) checkCone(check, light);
    return check.fault();
}

void store(float (&target)[3], glm::dvec3 value)
{
    for (int channel = 0; channel < 3; ++channel) target[channel] = static_cast<float>(value[channel]);
}

}  // namespace

Result<LightBlock> packLight(const LightSource& light)
{
    if (const std::string fault = faultOf(light); !fault.empty()) return Error{"nacre::packLight(): " + fault};
    const model::LightSource source = model::derive(light);
    LightBlock block{};
    store(block.colour, source.colour);
    block.inverseRange = static_cast<float>(source.inverseRange);
    store(block.position, source.position);
    block.kind = static_cast<std::int32_t>(source.kind);
    store(block.direction, source.direction);
    block.angleScale = static_cast<float>(source.angleScale);
    block.angleOffset = static_cast<float>(source.angleOffset);
    return block;
}

Result<std::vector<unsigned char>> packLights(const std::vector<LightSource>& lights, int most)
{
    if (most < 1) return Error{"nacre::packLights(): expected room for 1 light or more, got " + std::to_string(most)};
    if (lights.size() > static_cast<std::size_t>(most)) {
        return Error{"nacre::packLights(): expected at most " + std::to_string(most) + " lights, got " + std::to_string(lights.size())};
    }
    std::vector<unsigned char> bytes(sizeof(LightHeader) + static_cast<std::size_t>(most) * sizeof(LightBlock));
    const LightHeader header{static_cast<std::int32_t>(lights.size()), {}};
    std::memcpy(bytes.data(), &header, sizeof header);
    unsigned char* target = bytes.data() + sizeof header;
    for (const LightSource& light : lights) {
        const Result<LightBlock> block = packLight(light);
        if (!block) {
            const std::string& reason = block.error().message;
            const std::string index = std::to_string(&light - lights.data());
            return Error{"nacre::packLights(): lights[" + index + "]: " + reason.substr(reason.find(": ") + 2)};
        }
        std::memcpy(target, &*block, sizeof *block);
        target += sizeof *block;
    }
    return bytes;
}

}  // namespace nacre
