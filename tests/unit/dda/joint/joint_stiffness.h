// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef hybrid_tests_joint_stiffness_h
#define hybrid_tests_joint_stiffness_h

/// Stiffnesses of the joints whose laws are tested [Pa/m].
constexpr double k_n = 2e9, k_s = 1e9;

#endif
