// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_record.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace hybrid::output
{
  namespace
  {
    struct StepRecordFile : testing::Test
    {
      const std::string file = testing::TempDir() + "step_record_test.bin";

      void TearDown() override
      {
        std::filesystem::remove(file);
      }
    };



    TEST_F(StepRecordFile, gives_back_what_was_written)
    {
      StepRecord record;
      record.step       = 2e-3;
      record.time       = {1., 2.};
      record.monitors   = {{"S1", {{{1., 2., 3., 4.}, {5., 6., 7., 8.}, {9., 1., 2., 3.}}}}};
      record.base       = 0;
      record.corner     = 25.;
      record.difference = {{0.1, 0.2, 0.3}};
      write_step_record(file, record);
      const std::optional<StepRecord> read = read_step_record(file);
      ASSERT_TRUE(read);
      EXPECT_EQ(read->step, record.step);
      EXPECT_EQ(read->time, record.time);
      ASSERT_EQ(read->monitors.size(), 1u);
      EXPECT_EQ(read->monitors[0].name, "S1");
      EXPECT_EQ(read->monitors[0].histories, record.monitors[0].histories);
      EXPECT_TRUE(std::isnan(read->until));
      EXPECT_EQ(read->difference, record.difference);
    }



    TEST_F(StepRecordFile, there_need_be_none)
    {
      EXPECT_FALSE(read_step_record(file));
    }



    TEST_F(StepRecordFile, a_damaged_one_is_refused)
    {
      std::ofstream(file) << "no checkpoint";
      EXPECT_THROW(read_step_record(file), InputError);
    }
  } // namespace
} // namespace hybrid::output
