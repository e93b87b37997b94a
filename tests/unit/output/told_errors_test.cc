// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/told_errors.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace hybrid::output
{
  namespace
  {
    struct ToldErrorsFile : testing::Test
    {
      const std::string file = testing::TempDir() + "told_errors_test.bin";

      void TearDown() override
      {
        std::filesystem::remove(file);
      }
    };



    TEST_F(ToldErrorsFile, gives_back_what_was_written)
    {
      ToldErrors told;
      told.asked                = {1000, 2., 5e-4, true};
      told.step.reason          = "";
      told.step.measured_from   = 5e-4;
      told.step.step.part       = {{0.01, 0.02, 0.03}};
      told.step.step.where      = {{"S1", "S2", "S3"}};
      told.step.failed_in_other = true;
      told.step.until_later     = 1.5;
      told.mesh.reason          = "the next mesh is hardly coarser";
      told.mesh.order_is_seen   = true;
      write_told_errors(file, told);
      const std::optional<ToldErrors> read = read_told_errors(file);
      ASSERT_TRUE(read);
      EXPECT_TRUE(read->asked == told.asked);
      EXPECT_EQ(read->step.reason, "");
      EXPECT_EQ(read->step.measured_from, 5e-4);
      EXPECT_EQ(read->step.step.part, told.step.step.part);
      EXPECT_EQ(read->step.step.where, told.step.step.where);
      EXPECT_TRUE(std::isnan(read->step.step.slip_left));
      EXPECT_TRUE(read->step.failed_in_other);
      EXPECT_EQ(read->step.until_later, 1.5);
      EXPECT_EQ(read->mesh.reason, told.mesh.reason);
      EXPECT_TRUE(read->mesh.order_is_seen);
    }



    TEST_F(ToldErrorsFile, there_need_be_none)
    {
      EXPECT_FALSE(read_told_errors(file));
    }



    TEST_F(ToldErrorsFile, a_damaged_one_tells_nothing)
    {
      write_told_errors(file, ToldErrors());
      ASSERT_TRUE(read_told_errors(file));
      std::filesystem::resize_file(file, 40);
      EXPECT_FALSE(read_told_errors(file));
      std::filesystem::resize_file(file, 0);
      EXPECT_FALSE(read_told_errors(file));
      std::ofstream(file) << "no errors";
      EXPECT_FALSE(read_told_errors(file));
    }



    TEST(ToldErrors, are_of_a_run_with_the_same_steps_and_questions)
    {
      const ToldErrors::Asked asked = {1000, 2., 5e-4, true};
      EXPECT_TRUE(asked == asked);
      EXPECT_FALSE(asked == (ToldErrors::Asked{2000, 2., 5e-4, true}));
      EXPECT_FALSE(asked == (ToldErrors::Asked{1000, 4., 5e-4, true}));
      EXPECT_FALSE(asked == (ToldErrors::Asked{1000, 2., 2e-3, true}));
      EXPECT_FALSE(asked == (ToldErrors::Asked{1000, 2., 5e-4, false}));
    }
  } // namespace
} // namespace hybrid::output
