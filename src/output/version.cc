// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/version.h>

#include <deal.II/base/config.h>

#include <Eigen/Core>
#include <Trilinos_version.h>
#include <cholmod.h>
#include <gmsh.h>
#include <hdf5.h>
#include <hybrid_commit.h>
#include <mpi.h>

#include <sstream>

extern "C" char *
openblas_get_config();

namespace hybrid::output
{
  namespace
  {
    template <typename... Numbers>
    std::string dotted(const Numbers... numbers)
    {
      std::string text;
      ((text += (text.empty() ? "" : ".") + std::to_string(numbers)), ...);
      return text;
    }


    std::string gmsh_version()
    {
      std::string version = GMSH_API_VERSION;
      gmsh::initialize(0, nullptr, false);
      gmsh::option::getString("General.Version", version);
      gmsh::finalize();
      return version;
    }


    std::string hdf5_version()
    {
      unsigned int number[3] = {};
      H5get_libversion(&number[0], &number[1], &number[2]);
      return dotted(number[0], number[1], number[2]);
    }


    /// "Open MPI v4.1.4, package: ..." -> "Open MPI v4.1.4"
    std::string mpi_version()
    {
      char text[MPI_MAX_LIBRARY_VERSION_STRING];
      int  length = 0;
      MPI_Get_library_version(text, &length);
      const std::string whole(text, length);
      return whole.substr(0, whole.find_first_of(",\n"));
    }
  } // namespace



  std::string version_text()
  {
    std::ostringstream text;
    text << "hybrid " << HYBRID_VERSION << " (commit " << HYBRID_COMMIT << ")\n"
         << "compiler    " << __VERSION__ << "\n"
         << "flags       " << HYBRID_COMPILER_FLAGS << "\n"
         << "deal.II     " << DEAL_II_PACKAGE_VERSION << "\n"
         << "Trilinos    " << TRILINOS_VERSION_STRING << "\n"
         << "gmsh        " << gmsh_version() << "\n"
         << "Eigen       " << dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)
         << "\n"
         << "SuiteSparse "
         << dotted(SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION)
         << "\n"
         << "OpenBLAS    " << openblas_get_config() << "\n"
         << "HDF5        " << hdf5_version() << "\n"
         << "MPI         " << mpi_version() << "\n";
    return text.str();
  }
} // namespace hybrid::output
