// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/shared_checkpoint.h>
#include <hybrid/restart/shared_file.h>
#include <hybrid/scene/input_error.h>

#include <limits>

namespace hybrid::restart
{
  namespace
  {
    constexpr std::uint64_t nowhere = std::numeric_limits<std::uint64_t>::max();



    /// A block that all ranks are to write, as the first one tells them.
    struct Block
    {
      std::uint64_t vector, number, position; ///< position: in the file
    };



    /// What a rank does for a shared checkpoint.
    class Writing
    {
    public:
      Writing(const std::string               &file_name,
              const std::vector<SharedVector> &shared,
              const MPI_Comm                   communicator)
        : file(file_name, communicator)
        , vectors(shared)
        , comm(communicator)
      {
        MPI_Comm_rank(comm, &rank);
        MPI_Comm_size(comm, &ranks);
      }

      /// The first rank goes through the state, and calls for the others where it meets a vector.
      void lead(const std::uint64_t layout, const std::function<void(Archive &)> &write_state)
      {
        const auto write = [this](const std::string_view bytes) {
          file.write(position, bytes);
          position += bytes.size();
        };
        put_checkpoint(write, layout, sum, [&](Archive &archive) {
          for (std::size_t k = 0; k < vectors.size(); ++k)
            archive.stand_in(*vectors[k].vector, [this, k](Archive &state) { put(state, k); });
          write_state(archive);
        });
        tell({nowhere, 0, 0});
      }

      void follow()
      {
        for (Block block = told(); block.vector != nowhere; block = told())
          write_portion(block);
      }

      void finish()
      {
        file.finish(true);
      }

    private:
      void put(Archive &state, const std::size_t k)
      {
        const SharedVector &vector = vectors[k];
        state.put(static_cast<std::uint64_t>(vector.is_empty ? 0 : vector.length()));
        for (std::size_t b = 0; !vector.is_empty && b < vector.blocks; ++b)
          {
            state.flush();
            const Block block{k, b, position};
            tell(block);
            write_portion(block);
            position += vector.shared * sizeof(double);
            for (std::size_t i = 0; i < vector.alike; ++i)
              state.put(vector.rest(b)[i]);
          }
      }

      void write_portion(const Block &block)
      {
        const std::vector<double> mine = vectors[block.vector].portion(block.number);
        std::uint64_t             size = mine.size() * sizeof(double), before = 0;
        MPI_Exscan(&size, &before, 1, MPI_UINT64_T, MPI_SUM, comm);
        const std::string_view bytes(reinterpret_cast<const char *>(mine.data()), size);
        file.write(block.position + (rank > 0 ? before : 0), bytes); // the first one's is undefined
        pass_on(bytes);
      }

      /// The checksum goes from rank to rank and back to the first one: bytes count in their order.
      void pass_on(const std::string_view bytes)
      {
        if (rank > 0)
          MPI_Recv(&sum, 1, MPI_UINT64_T, rank - 1, 0, comm, MPI_STATUS_IGNORE);
        sum = checksum(bytes, sum);
        if (ranks == 1)
          return;
        MPI_Send(&sum, 1, MPI_UINT64_T, (rank + 1) % ranks, 0, comm);
        if (rank == 0)
          MPI_Recv(&sum, 1, MPI_UINT64_T, ranks - 1, 0, comm, MPI_STATUS_IGNORE);
      }

      void tell(Block block) const
      {
        MPI_Bcast(&block, sizeof(block), MPI_BYTE, 0, comm);
      }

      Block told() const
      {
        Block block;
        MPI_Bcast(&block, sizeof(block), MPI_BYTE, 0, comm);
        return block;
      }

      SharedFile                       file;
      const std::vector<SharedVector> &vectors;
      MPI_Comm                         comm;
      int                              rank = 0, ranks = 1;
      std::uint64_t                    position = 0, sum = checksum({}); ///< of the first rank
    };
  } // namespace



  void write_shared_checkpoint(const std::string                    &file_name,
                               const std::uint64_t                   layout,
                               const std::function<void(Archive &)> &write_state,
                               const std::vector<SharedVector>      &vectors,
                               const MPI_Comm                        communicator)
  {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    Writing writing(file_name, vectors, communicator);
    if (rank == 0)
      writing.lead(layout, write_state);
    else
      writing.follow();
    writing.finish();
  }



  SharedReading::SharedReading(Archive &archive, const std::vector<SharedVector> &shared)
    : vectors(shared)
    , places(shared.size(), nowhere)
  {
    for (std::size_t k = 0; k < vectors.size(); ++k)
      archive.stand_in(*vectors[k].vector, [this, k](Archive &state) {
        std::uint64_t length = 0;
        state(length);
        if (length != 0 && length != vectors[k].length())
          throw InputError("the checkpoint has another number of unknowns than the scene");
        const std::size_t place = state.skip(length * sizeof(double));
        places[k]               = length == 0 ? nowhere : place;
      });
  }



  void SharedReading::take(const std::string_view state, const MPI_Comm communicator)
  {
    MPI_Bcast(places.data(), static_cast<int>(places.size()), MPI_UINT64_T, 0, communicator);
    for (std::size_t k = 0; k < vectors.size(); ++k)
      for (std::size_t b = 0; places[k] != nowhere && b < vectors[k].blocks; ++b)
        vectors[k].take(b,
                        state.data() + places[k] +
                          b * (vectors[k].shared + vectors[k].alike) * sizeof(double));
  }
} // namespace hybrid::restart
