// nacre-eval as someone who checks the numbers meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "process.hpp"
#include "vectors.hpp"

namespace {

using namespace nacre::test;

const std::string header =
    "lx,ly,lz,vx,vy,vz,n0x,n0y,n0z,n1x,n1y,n1z,ior_r,ior_g,ior_b,thickness_nm,e0,e1,ior_outside,wavelength_nm_r,wavelength_nm_g,"
    "wavelength_nm_b";
const std::string row = "0,0,1,0,0,1,0,0,1,0,0,1,1.4,1.45,1.6,300,90,170,1,645,525,445";

Finished eval(const std::string& csv, const std::string& arguments = "")
{
    return run("printf '%s' '" + csv + "' | " NACRE_EVAL " " + arguments);
}

void expectRefusal(const std::string& csv, const std::string& message, const std::string& arguments = "")
{
    const Finished finished = eval(csv, arguments);
    EXPECT_GT(finished.status, 0) << finished.output;
    EXPECT_EQ(finished.output.substr(0, 12 + message.size()), "nacre-eval: " + message);
    EXPECT_EQ(std::count(finished.output.begin(), finished.output.end(), '\n'), 1) << finished.output;
}

TEST(Eval, KeepsInputsAndAddsResultsOnBothSides)
{
    for (const char* on : {"--on cpu", "--on gpu"}) {
        const Finished finished = eval(header + "\n" + row + "\n", on);
        ASSERT_EQ(finished.status, 0) << finished.output;
        std::istringstream stream(finished.output);
        const CsvTable table = *CsvTable::read(stream);
        ASSERT_EQ(table.rows.size(), 1U);
        ASSERT_EQ(table.columns.size(), inputColumns().size() + resultColumns().size());
        EXPECT_EQ(finished.output.find(row), finished.output.find('\n') + 1);  // inputs as they were written
        EXPECT_NEAR(*number(table, 0, table.find("R_r")), (0.4 / 2.4) * (0.4 / 2.4), 1e-7);
    }
}

TEST(Eval, OtherColumnsAndAnyOrderWillDo)
{
    const Finished plain = eval(header + "\n" + row + "\n");
    const Finished more = eval("comment," + header + "\nanything," + row + "\n");
    EXPECT_EQ(plain.output, more.output);
}

TEST(Eval, NoRowsGiveAHeader)
{
    const Finished finished = eval(header + "\n", "--on gpu");
    EXPECT_EQ(finished.status, 0) << finished.output;
    EXPECT_EQ(std::count(finished.output.begin(), finished.output.end(), '\n'), 1);
}

TEST(Eval, RefusesBadInput)
{
    expectRefusal("", "CSV: expected a header line, got nothing");
    expectRefusal("lx,ly\n0,0\n", "CSV: expected a column lz, there is none");
    expectRefusal(header + "\n1,2\n", "CSV row 1: expected 22 cells, got 2");
    expectRefusal(header + "\n" + row + "\nx" + row.substr(1) + "\n", "CSV row 2, column lx: expected a number, got 'x'");
    expectRefusal(header + "\n0,0,1,0,0,1,0,0,1,0,0,1,-1.4,1.45,1.6,300,90,170,1,645,525,445\n",
                  "CSV row 1: nacre::evaluate(): expected 0.1 <= ior.r <= 10, got -1.4");
    expectRefusal(header + "\n0,0,nan,0,0,1,0,0,1,0,0,1,1.4,1.45,1.6,300,90,170,1,645,525,445\n",
                  "CSV row 1: nacre::evaluate(): expected a finite light");
    expectRefusal(header + "\n" + row + "\n", "--on: ", "--on tpu");
}

}  // namespace
