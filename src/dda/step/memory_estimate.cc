// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/step/memory_estimate.h>

#include <algorithm>
#include <cholmod.h>

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



    /// Entries of the Cholesky factor of a matrix with one number per block and pair.
    double factor_entries(const int n_blocks, const std::vector<BlockMatrix::Pair> &pairs)
    {
      cholmod_common common;
      cholmod_start(&common);
      common.print          = 0;
      cholmod_triplet *list = cholmod_allocate_triplet(
        n_blocks, n_blocks, n_blocks + pairs.size(), 1, CHOLMOD_PATTERN, &common);
      const auto add = [&](const int i, const int j) {
        static_cast<int *>(list->i)[list->nnz]   = i;
        static_cast<int *>(list->j)[list->nnz++] = j;
      };
      for (int b = 0; b < n_blocks; ++b)
        add(b, b);
      for (const auto &pair : pairs)
        add(pair[0], pair[1]);
      cholmod_sparse *matrix  = cholmod_triplet_to_sparse(list, 0, &common);
      cholmod_factor *factor  = cholmod_analyze(matrix, &common);
      const double    entries = common.lnz;
      cholmod_free_factor(&factor, &common);
      cholmod_free_sparse(&matrix, &common);
      cholmod_free_triplet(&list, &common);
      cholmod_finish(&common);
      return entries;
    }
  } // namespace



  double estimated_memory(const Model &model)
  {
    const auto   pairs    = block_pairs(model);
    const double n        = model.n_blocks();
    const double coupled  = 2. * static_cast<double>(pairs.size());
    const double springs  = 2. * static_cast<double>(model.joints.size());
    const double entries  = factor_entries(model.n_blocks(), pairs);
    const double per_mat6 = sizeof(Mat6);

    const double in_springs = springs * (sizeof(Springs::Spring) + sizeof(Springs::Response) +
                                         SpringStiffness::bytes_per_spring());
    const double in_state =
      n * sizeof(BlockState) + static_cast<double>(model.joints.size()) * sizeof(JointState);
    // The inverse diagonal and the copy that is swept, too.
    const double in_matrix = (2. * n + 2. * coupled) * per_mat6;
    const double in_copy   = (n + coupled) * (per_mat6 + 36. * sizeof(int));
    return in_springs + in_state + in_matrix + in_copy + 2. * entries * per_mat6;
  }
} // namespace hybrid::dda
