// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/crash_guard.h>

#include <gtest/gtest.h>

#include <csignal>

namespace hybrid::scene
{
  namespace
  {
    TEST(CrashGuard, ACrashIsAnErrorOfTheFile)
    {
      EXPECT_EXIT(
        {
          const CrashGuard guard("slab.geo");
          std::raise(SIGSEGV);
        },
        testing::ExitedWithCode(2),
        "error: slab.geo: gmsh crashes on this file");
    }


    TEST(CrashGuard, ACrashAfterACompleteRunIsNone)
    {
      EXPECT_EXIT(
        {
          CrashGuard::spoils_nothing("not told, gmsh crashes on a coarser mesh of ");
          CrashGuard guard("slab.geo");
          guard.suspect("a curve");
          std::raise(SIGABRT);
        },
        testing::ExitedWithCode(0),
        "^not told, gmsh crashes on a coarser mesh of slab.geo");
      EXPECT_EXIT(
        {
          CrashGuard::spoils_nothing("not told");
          CrashGuard::spoils_nothing("");
          const CrashGuard guard("slab.geo");
          std::raise(SIGSEGV);
        },
        testing::ExitedWithCode(2),
        "error: slab.geo");
    }
  } // namespace
} // namespace hybrid::scene
