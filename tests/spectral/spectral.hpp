#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include <nacre/result.hpp>

namespace nacre::test {

/// Reflectance of each polarisation.
struct Reflectance {
    double s, p;
    double mean() const { return 0.5 * (s + p); }
};

/// A film in air on a substrate, at one wavelength; exact. Airy 1833, as in Born & Wolf, Sec 7.6.1: no
/// series, no angle but the ray's own, nothing of the library's. substrate = n + i k; cosTheta outside.
Reflectance airy(double index, std::complex<double> substrate, double thicknessNm, double cosTheta, double wavelengthNm);

/// A film by its spectra. Indices are functions of the wavelength in nm.
struct SpectralFilm {
    std::function<double(double)> index;
    std::function<std::complex<double>(double)> substrate;
    double thicknessNm;
    double cosTheta;
};

/// Cauchy's dispersion: n(λ) = a + b / λ², λ in µm.
std::function<double(double)> cauchy(double a, double bUm2);

enum class Illuminant { equalEnergy, d65 };

/// The CIE 1931 standard observer by 1 nm in linear Rec.709, the light adapted to D65 by Bradford, so
/// that a flat reflectance is grey.
class Observer {
public:
    explicit Observer(Illuminant illuminant = Illuminant::equalEnergy);

    /// The colour of a reflectance spectrum. Channels outside the gamut are not clipped.
    glm::dvec3 colour(const std::function<double(double)>& reflectance) const;
    glm::dvec3 colour(const SpectralFilm& film) const;
    /// One channel of it: for substrates whose index is constant within each channel.
    double channel(const SpectralFilm& film, int channel) const;

    /// The curves' values, by 1 nm from 360 to 830 nm; each channel's sum is 1.
    const std::vector<glm::dvec3>& curves() const { return curves_; }

private:
    std::vector<glm::dvec3> curves_;
};

/// CIEDE2000 of two linear Rec.709 colours, both clipped at 0; white is the perfect reflector.
double colourDifference(glm::dvec3 a, glm::dvec3 b);
/// The same of CIELAB values (Sharma, Wu & Dalal 2005).
double ciede2000(glm::dvec3 lab1, glm::dvec3 lab2);

/// A measured metal: n + i k by wavelength, linear between tests/spectral/data/metals.csv's rows.
/// name: al, cu, au, fe.
Result<std::function<std::complex<double>(double)>> metal(const std::string& name);

}  // namespace nacre::test
