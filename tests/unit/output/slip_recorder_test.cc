// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/slip_recorder.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace hybrid;



namespace
{
  /// What a mass of two blocks mobilises that is sheared uphill, or on level ground towards -x, by
  /// half of its strength.
  output::Summary::BaseShear sheared_uphill(const double downhill)
  {
    dda::Model model = dda::build_model(hybrid::test::square_blocks(2, 1, 2.),
                                        hybrid::test::block_parameters(30.),
                                        hybrid::test::straight_foundation(0., 1., 6., 7));
    model.downhill.sign.assign(2, downhill);
    dda::DdaState        state = dda::initial_state(model);
    const std::string    path  = std::filesystem::temp_directory_path() / "slip_recorder_test.h5";
    output::HistoryFile  file(path, output::HistoryFile::Mode::create);
    output::SlipRecorder recorder(&model, 1e-3);
    recorder.add_series(file);
    state.surface_force.strength = 2e6;
    recorder.set_reference(state, file);
    state.surface_force.shear = -1e6;
    recorder.record(state, file);
    output::Summary summary;
    recorder.finish(state, file, summary);
    std::filesystem::remove(path);
    return summary.base_shear;
  }
} // namespace



TEST(SlipRecorder, shear_that_is_mobilised_counts_downhill)
{
  for (const double downhill : {-1., 1.})
    {
      EXPECT_DOUBLE_EQ(sheared_uphill(downhill).mobilised_left, -0.5);
      EXPECT_DOUBLE_EQ(sheared_uphill(downhill).mobilised, -0.5);
      EXPECT_DOUBLE_EQ(sheared_uphill(downhill).mobilised_at_rest, 0.);
      EXPECT_DOUBLE_EQ(sheared_uphill(downhill).shear_left, -1e6);
    }
}



TEST(SlipRecorder, on_level_ground_its_size_counts)
{
  EXPECT_DOUBLE_EQ(sheared_uphill(0.).mobilised, 0.5);
  EXPECT_DOUBLE_EQ(sheared_uphill(0.).mobilised_left, 0.5);
  EXPECT_DOUBLE_EQ(sheared_uphill(0.).shear_left, -1e6);
}
