#pragma once

#include <fstream>
#include <map>
#include <string>

#include <glm/vec4.hpp>

namespace nacre::demo {

/// What goes on, a line each, for scripts that drive the viewer (--log): `NAME VALUE`. Without a file it does nothing.
class Log {
public:
    Log() = default;
    explicit Log(const std::string& file) : stream_(file), isOn_(true) {}
    bool isOn() const { return isOn_; }
    bool isGood() const { return static_cast<bool>(stream_); }

    /// Always written.
    void event(const std::string& name, const std::string& value);
    /// Written where the value is another than before.
    void state(const std::string& name, const std::string& value);
    /// Where the widget that was just made stands: `widget:NAME LEFT TOP RIGHT BOTTOM` in the window's pixels.
    void widget(const std::string& name);

private:
    std::ofstream stream_;
    bool isOn_ = false;
    std::map<std::string, std::string> last_;
};

}  // namespace nacre::demo
