// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/processes.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

namespace hybrid
{
  namespace
  {
    constexpr int exit_code_of_error = 2;



    /// The number of this process as mpirun says it, which is known before MPI starts.
    bool is_told_to_be_another()
    {
      for (const char *name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
        if (const char *rank = std::getenv(name))
          return std::string(rank) != "0";
      return false;
    }
  } // namespace



  void Processes::start(int &argc, char **&argv)
  {
    int is_initialized = 0;
    MPI_Initialized(&is_initialized);
    is_owner = is_initialized == 0;
    if (is_owner)
      MPI_Init(&argc, &argv);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
  }



  Processes::~Processes()
  {
    if (is_owner)
      MPI_Finalize();
  }



  bool Processes::is_first() const
  {
    int is_initialized = 0, rank = 0;
    MPI_Initialized(&is_initialized);
    if (is_initialized == 0)
      return !is_told_to_be_another();
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank == 0;
  }



  int Processes::on_this_machine() const
  {
    int      result = 1;
    MPI_Comm neighbours;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &neighbours);
    MPI_Comm_size(neighbours, &result);
    MPI_Comm_free(&neighbours);
    return result;
  }



  void Processes::on_first(const std::function<void()> &work) const
  {
    int                failed = 0;
    std::exception_ptr error;
    if (is_first())
      try
        {
          work();
        }
      catch (...)
        {
          failed = 1;
          error  = std::current_exception();
        }
    if (are_there_others())
      MPI_Bcast(&failed, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (error)
      std::rethrow_exception(error);
    if (failed != 0)
      throw FirstProcessFailed{exit_code_of_error};
  }



  double Processes::from_first(double value) const
  {
    if (are_there_others())
      MPI_Bcast(&value, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    return value;
  }



  int Processes::wait_for_first() const
  {
    constexpr auto pause = std::chrono::milliseconds(20); // MPI's own waiting takes a whole core
    int            code = 0, is_there = 0;
    MPI_Request    request;
    MPI_Ibcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD, &request);
    for (MPI_Test(&request, &is_there, MPI_STATUS_IGNORE); is_there == 0;
         MPI_Test(&request, &is_there, MPI_STATUS_IGNORE))
      std::this_thread::sleep_for(pause);
    return code;
  }



  void Processes::release(int exit_code)
  {
    if (!others_wait || !is_first())
      return;
    others_wait = false;
    MPI_Request request;
    MPI_Ibcast(&exit_code, 1, MPI_INT, 0, MPI_COMM_WORLD, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
  }



  void Processes::end_all(const int exit_code) const
  {
    if (together)
      MPI_Abort(MPI_COMM_WORLD, exit_code);
  }
} // namespace hybrid
