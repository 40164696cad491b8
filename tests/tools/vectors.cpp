#include "vectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace nacre::test {
namespace {

std::vector<std::string> perChannel(const std::vector<std::string>& names)
{
    std::vector<std::string> columns;
    for (const std::string& name : names) {
        for (const char* channel : {"_r", "_g", "_b"}) columns.push_back(name + channel);
    }
    return columns;
}

// Unit length whatever the size; NaN where there is no direction, which evaluate() then refuses.
glm::dvec3 unit(glm::dvec3 a)
{
    const double largest = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
    const glm::dvec3 scaled = a / largest;
    // What is a unit vector but for float32's rounding of its components is divided once, not twice.
    return largest > 1e-100 && largest < 1e100 ? glm::normalize(a) : glm::normalize(scaled);
}

// A normal as it stands, for the shader to normalise, unless float32 cannot hold it.
glm::vec3 inFloat(glm::dvec3 normal)
{
    const double largest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
    return largest > 0.0 && (largest < 1e-30 || largest > 1e30) ? unit(normal) : normal;
}

// The cells of a row as the columns name them, in inputColumns()' order.
Case caseFrom(const std::vector<double>& cell, Quality quality)
{
    std::size_t next = 0;
    const auto real = [&] { return cell[next++]; };
    const auto vector = [&] {
        const double x = real(), y = real(), z = real();
        return glm::dvec3(x, y, z);
    };
    Case one;
    one.light = vector();
    one.view = vector();
    one.surface.upperNormal = vector();
    one.surface.lowerNormal = vector();
    one.material.ior = vector();
    one.surface.thicknessNm = real();
    one.material.thicknessLeastNm = one.material.thicknessMostNm = one.surface.thicknessNm;
    one.material.upperExponent = real();
    one.material.lowerExponent = real();
    one.material.iorOutside = real();
    one.material.wavelengthNm = vector();
    one.material.quality = quality;
    if (quality == Quality::physical) {
        one.material.substrateIndex = vector();
        one.material.substrateAbsorption = vector();
        const bool absorbs = glm::any(glm::notEqual(one.material.substrateAbsorption, glm::dvec3(0.0)));
        one.material.substrate = absorbs ? Substrate::metal : Substrate::dielectric;
    }
    return one;
}

}  // namespace

const std::vector<std::string>& inputColumns(Quality quality)
{
    static const std::vector<std::string> columns = {
        "lx",    "ly",    "lz",    "vx",           "vy", "vz", "n0x",         "n0y",             "n0z",            "n1x", "n1y", "n1z",
        "ior_r", "ior_g", "ior_b", "thickness_nm", "e0", "e1", "ior_outside", "wavelength_nm_r", "wavelength_nm_g", "wavelength_nm_b"};
    static const std::vector<std::string> physical = [] {
        std::vector<std::string> all = columns;
        for (const std::string& column : perChannel({"substrate_n", "substrate_k"})) all.push_back(column);
        return all;
    }();
    return quality == Quality::physical ? physical : columns;
}

const std::vector<std::string>& resultColumns()
{
    static const std::vector<std::string> columns = perChannel({"rho", "R", "T", "phi", "diffuse", "mean_cos"});
    return columns;
}

Result<std::vector<Case>> readCases(const CsvTable& table, Quality quality)
{
    std::vector<std::size_t> indices;
    for (const std::string& column : inputColumns(quality)) {
        indices.push_back(table.find(column));
        if (indices.back() == table.columns.size()) return Error{"CSV: expected a column " + column + ", there is none"};
    }
    std::vector<Case> cases;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double> cells;
        for (std::size_t index : indices) {
            Result<double> cell = number(table, row, index);
            if (!cell) return cell.error();
            cells.push_back(*cell);
        }
        cases.push_back(caseFrom(cells, quality));
        Result<Evaluation> evaluation = evaluate(cases.back());
        if (!evaluation) return Error{"CSV row " + std::to_string(row + 1) + ": " + evaluation.error().message};
    }
    return cases;
}

Result<Evaluation> evaluate(const Case& one, const FringeTable* fringeTable)
{
    return nacre::evaluate(one.material, one.surface, unit(one.light), unit(one.view), fringeTable);
}

Result<GpuInput> gpuInput(const Case& one)
{
    Result<Block> block = nacre::pack(one.material);
    if (!block) return block.error();
    return GpuInput{*block,
                    unit(one.light),
                    unit(one.view),
                    inFloat(one.surface.upperNormal),
                    inFloat(one.surface.lowerNormal),
                    static_cast<float>(one.surface.thicknessNm / 1000.0)};
}

std::array<double, 18> results(const Evaluation& e)
{
    std::array<double, 18> all{};
    std::size_t next = 0;
    for (const glm::dvec3& value : {e.rho, e.R, e.T, e.phi, e.diffuse, e.meanCos}) {
        for (int channel = 0; channel < 3; ++channel) all[next++] = value[channel];
    }
    return all;
}

std::array<double, 18> results(const Case& one, const GpuOutput& o)
{
    Evaluation e{};
    e.rho = o.rho;
    e.R = o.R;
    e.T = o.T;
    e.phi = o.phi;
    e.diffuse = o.diffuse;
    // The shader has no NaN to give; where Eq 14 is not defined it gives 0.
    for (int channel = 0; channel < 3; ++channel) {
        const bool isDefined = one.material.ior[channel] >= one.material.iorOutside;
        e.meanCos[channel] = isDefined ? static_cast<double>(o.meanCos[channel]) : std::numeric_limits<double>::quiet_NaN();
    }
    return results(e);
}

}  // namespace nacre::test
