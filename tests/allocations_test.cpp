// What is done per material, per light and per draw asks for no memory.

#include <gtest/gtest.h>

#include <new>
#include <vector>

#include <nacre/block.hpp>
#include <nacre/features.hpp>
#include <nacre/fringe_table.hpp>
#include <nacre/lights.hpp>
#include <nacre/presets.hpp>
#include <nacre/uniforms.hpp>

#include "allocations.hpp"
#include "null_gl.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

template <class Work>
std::size_t allocationsOf(const Work& work)
{
    work();  // what is made once, tables of names, is not counted
    const std::size_t before = allocations();
    work();
    return allocations() - before;
}

std::vector<Material> materials()
{
    std::vector<Material> all;
    for (const Preset& preset : presets()) {
        for (const Quality quality : {Quality::paper, Quality::physical}) {
            for (const Substrate substrate : {Substrate::dielectric, Substrate::metal, Substrate::f0}) {
                all.push_back(preset.material);
                all.back().quality = quality;
                all.back().substrate = substrate;
                all.back().substrateAbsorption = glm::dvec3(3.0);
                all.back().lobes = Lobes::normalised;
            }
        }
    }
    return all;
}

TEST(Allocations, AreCounted)
{
    EXPECT_EQ(allocationsOf([] { ::operator delete(::operator new(4)); }), 1U);
    EXPECT_EQ(allocationsOf([] { ::operator delete[](::operator new[](4)); }), 1U);
    Material bad;
    bad.iorOutside = -1.0;
    EXPECT_GT(allocationsOf([&] { EXPECT_FALSE(pack(bad)); }), 0U);
}

TEST(Allocations, PackingAMaterialMakesNone)
{
    const FringeTable table = *FringeTable::create();
    for (const Material& material : materials()) {
        EXPECT_EQ(allocationsOf([&] { (void)*pack(material); }), 0U);
        EXPECT_EQ(allocationsOf([&] { (void)*pack(material, &table); }), 0U);
    }
}

TEST(Allocations, SettingAMaterialMakesNoneAndSetsEveryMember)
{
    const Uniforms uniforms = *Uniforms::locate(nullGl(), 1);
    const Block block = *pack(Material{});
    EXPECT_EQ(allocationsOf([&] { uniforms.set(block); }), 0U);
    const long before = nullGlCalls();
    uniforms.set(block);
    EXPECT_EQ(nullGlCalls() - before, static_cast<long>(blockMembers().size()));
}

TEST(Allocations, FeaturesAndKeyMakeNone)
{
    for (const Material& material : materials()) {
        EXPECT_EQ(allocationsOf([&] { (void)key(*featuresOf(material)); }), 0U);
        EXPECT_EQ(allocationsOf([&] { (void)join(Features{}, *featuresOf(material)); }), 0U);
    }
}

TEST(Allocations, PackingALightMakesNone)
{
    for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot}) {
        LightSource light;
        light.kind = kind;
        EXPECT_EQ(allocationsOf([&] { (void)*packLight(light); }), 0U);
    }
}

}  // namespace
