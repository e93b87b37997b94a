// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_plan.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/step/memory_estimate.h>

#include <algorithm>
#include <omp.h>

namespace hybrid::dda
{
  namespace
  {
    /// Pairs of blocks with joints, each once, the smaller number first.
    std::vector<BlockMatrix::Pair> block_pairs(const Model &model)
    {
      std::vector<BlockMatrix::Pair> pairs;
      for (const Joint &joint : model.joints)
        if (joint.other != foundation_body)
          pairs.push_back({std::min(joint.block, joint.other), std::max(joint.block, joint.other)});
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
      return pairs;
    }
  } // namespace



  double estimated_memory(const Model &model)
  {
    const auto      pairs   = block_pairs(model);
    const double    n       = model.n_blocks();
    const double    coupled = 2. * static_cast<double>(pairs.size());
    const double    springs = 2. * static_cast<double>(model.joints.size());
    const FrontTree tree(model.n_blocks(), pairs);
    const double    per_mat6 = sizeof(Mat6);

    const double in_springs = springs * (sizeof(Springs::Spring) + sizeof(Springs::Response) +
                                         SpringStiffness::bytes_per_spring());
    const double in_state =
      n * sizeof(BlockState) + static_cast<double>(model.joints.size()) * sizeof(JointState);
    // The inverse diagonal and the copy that is swept, too.
    const double in_matrix = (2. * n + 2. * coupled) * per_mat6;
    // What is factored.
    const double    in_copy = (n + coupled) * per_mat6;
    const FrontPlan plan(tree, omp_get_max_threads() > 1);
    const double    work = static_cast<double>(plan.largest_panel) +
                        1.5 * static_cast<double>(plan.largest_own) * plan.largest_own;
    const double in_factor = (tree.entries + work) * per_mat6 +
                             static_cast<double>(plan.size) * sizeof(double) + n * 6. * sizeof(int);
    return in_springs + in_state + in_matrix + in_copy + in_factor;
  }
} // namespace hybrid::dda
