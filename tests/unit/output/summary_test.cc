// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/summary.h>
#include <hybrid/scene/input_error.h>

#include "python_check.h"

namespace hybrid::output
{
  namespace
  {
    using test::make_directory;
    using test::python_passes;

    TEST(Summary, JsonHasTheNamesThatScriptsRelyOn)
    {
      Summary summary;
      summary.title              = "slope \"A\"\n\\";
      summary.finished           = true;
      summary.steps              = 12000;
      summary.simulated_time     = 12.;
      summary.wall_time          = 0.1;
      summary.processor_time     = 0.2;
      summary.blocks             = 1326;
      summary.continuum_unknowns = 24106;
      summary.interface_unknowns = 478;
      summary.resolved_frequency = 2.5;
      summary.resolved_by_part   = {{"the continuum", 13.5}, {"the sliding mass", 2.5}};
      summary.motion_frequency   = 6.75;
      summary.energy_residual    = 1.25e-4;
      summary.joints             = {7, 9};
      summary.static_joints      = {1, 2};
      summary.slip               = {0.25, -0.5, {{3., 4.}}, 0.125, 0.375, 0.75, 1e-3, "-x", 2};
      summary.base_shear         = {1e6, 5e5, 2e6, 0.5, 1., MonitorSummary::unknown};
      summary.static_stage       = {true, true, false, true, 1e-10, 12, 0.25};
      summary.wasted             = {3, 2, 1, 80};
      summary.iterations         = 36000;
      summary.few_iterations     = 1200;
      summary.contact_search     = {12003, 40, 2};
      summary.timings["blocks"]  = 100.5;
      summary.energy["kinetic"]  = 1. / 3.;
      MonitorSummary &monitor    = summary.monitors["S1"];
      monitor.peak_displacement  = {{-0.25, 1e-300}};
      monitor.amplification      = {{2.5, std::numeric_limits<double>::infinity()}};

      const std::string directory = make_directory("summary");
      write_summary(summary, directory + "/summary.json");
      EXPECT_TRUE(python_passes(directory, R"(
import json
def refuse(name):
    raise ValueError(name)
s = json.load(open('summary.json'), parse_constant=refuse)
assert s['finished'] is True and s['title'] == 'slope "A"\n\\'
assert (s['steps'], s['blocks'], s['continuum_unknowns'], s['interface_unknowns']) == (12000, 1326, 24106, 478)
assert (s['simulated_time_s'], s['wall_time_s'], s['processor_time_s'], s['energy_residual']) == (12., 0.1, 0.2, 1.25e-4)
assert (s['cuts'], s['retries'], s['cuts_moved_too_far']) == (3, 2, 1)
assert (s['iterations'], s['few_body_iterations'], s['unconverged_iterations']) == (36000, 1200, 80)
assert s['contact_search'] == {'steps': 12003, 'searches': 40, 'lists': 2}
assert (s['resolved_frequency_hz'], s['motion_frequency_hz']) == (2.5, 6.75)
assert s['resolved_by_part_hz'] == {'the continuum': 13.5, 'the sliding mass': 2.5}
assert s['slip_m'] == {'mean': 0.25, 'largest': -0.5, 'largest_at': [3, 4], 'mean_left': 0.125, 'largest_left': 0.375,
                       'part_slipped': 0.75, 'threshold': 0.001, 'downhill': '-x', 'blocks_off_surface': 2}
assert s['base_shear'] == {'shear_N_per_m': 1e6, 'shear_left_N_per_m': 5e5, 'normal_left_N_per_m': 2e6, 'mobilised_at_rest': 0.5,
                           'mobilised': 1, 'mobilised_left': None}
assert s['static_stage'] == {'equilibrium': True, 'planes_hold': False, 'slid': True, 'residual': 1e-10, 'iterations': 12,
                             'largest_displacement_m': 0.25}
assert s['joints']['tensile'] == 7 and s['joints']['shear'] == 9
assert s['joints']['static'] == {'tensile': 1, 'shear': 2} and s['joints']['first_failure_time_s'] is None and s['joints']['first_loss_time_s'] is None
m = s['monitors']['S1']
assert m['peak_displacement_m'] == [-0.25, 1e-300] and m['amplification'] == [2.5, None]
for name in ('peak_velocity_m_s', 'peak_acceleration_m_s2', 'final_displacement_m', 'amplification_until_first_failure'):
    assert m[name] == [None, None]
assert s['timings_s'] == {'blocks': 100.5} and s['energy_J_per_m'] == {'kinetic': 1. / 3.}
)"));
    }


    TEST(Summary, TextThatIsNotUtf8LosesItsLettersAndNoMore)
    {
      Summary summary;
      summary.title               = "Erdrutsch bei K\xf6ln"; // Latin-1
      summary.monitors["S\xfc"
                       "d"]       = {};
      const std::string directory = make_directory("summary_text");
      write_summary(summary, directory + "/summary.json");
      EXPECT_TRUE(python_passes(directory, R"(
import json
s = json.load(open('summary.json', encoding='utf-8'))
assert s['title'] == 'Erdrutsch bei K\ufffdln' and list(s['monitors']) == ['S\ufffdd']
)"));
    }


    TEST(Summary, EmptySummaryIsValidAndAMissingDirectoryIsAnInputError)
    {
      const std::string directory = make_directory("summary_empty");
      write_summary(Summary(), directory + "/summary.json");
      EXPECT_TRUE(python_passes(directory, R"(
import json
s = json.load(open('summary.json'))
assert s['finished'] is False and s['monitors'] == {} and s['timings_s'] == {}
)"));
      EXPECT_THROW(write_summary(Summary(), directory + "/missing/summary.json"), InputError);
    }
  } // namespace
} // namespace hybrid::output
