// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace hybrid::restart
{
  namespace
  {
    enum class Colour
    {
      red,
      blue
    };

    struct Part
    {
      int    number = 0;
      double value  = 0.;
    };

    void serialize(Archive &archive, Part &part)
    {
      auto &[number, value] = part;
      archive(number, value);
    }

    class Whole
    {
    public:
      Part                          part;
      std::vector<Part>             parts;
      std::vector<std::vector<int>> rows;
      std::vector<Eigen::Vector2d>  places;
      Eigen::VectorXd               forces;
      Eigen::Matrix3d               matrix = Eigen::Matrix3d::Zero();
      std::string                   name;
      std::array<double, 2>         pair{};
      double                        plain[2] = {0., 0.};
      std::map<std::string, double> timings;
      Colour                        colour = Colour::red;
      bool                          flag   = false;

      void serialize(Archive &archive)
      {
        archive(
          part, parts, rows, places, forces, matrix, name, pair, plain, timings, colour, flag);
      }
    };

    Whole example()
    {
      Whole whole;
      whole.part     = {3, 0.1};
      whole.parts    = {{1, 1e-300}, {2, -0.}};
      whole.rows     = {{1, 2}, {}, {3}};
      whole.places   = {{1., 2.}, {3., 4.}};
      whole.forces   = Eigen::VectorXd::LinSpaced(5, 0., 1.);
      whole.matrix   = Eigen::Matrix3d::Identity();
      whole.name     = "Majiagou";
      whole.pair     = {{7., 8.}};
      whole.plain[1] = 9.;
      whole.timings  = {{"blocks", 2.}, {"continuum", 3.}};
      whole.colour   = Colour::blue;
      whole.flag     = true;
      return whole;
    }



    TEST(Archive, ReadsWhatItWrote)
    {
      Whole   whole  = example();
      Archive writer = Archive::writer();
      writer(whole);
      Archive reader = Archive::reader(writer.content());
      Whole   copy;
      copy.timings["gone"] = 1.; // stays: keys are added
      copy.timings.clear();
      reader(copy);
      EXPECT_TRUE(reader.at_end());
      EXPECT_EQ(copy.part.number, 3);
      EXPECT_EQ(copy.part.value, 0.1);
      ASSERT_EQ(copy.parts.size(), 2u);
      EXPECT_EQ(copy.parts[0].value, 1e-300);
      EXPECT_TRUE(std::signbit(copy.parts[1].value));
      EXPECT_EQ(copy.rows, whole.rows);
      EXPECT_EQ(copy.places, whole.places);
      EXPECT_EQ(copy.forces, whole.forces);
      EXPECT_EQ(copy.matrix, whole.matrix);
      EXPECT_EQ(copy.name, "Majiagou");
      EXPECT_EQ(copy.pair, whole.pair);
      EXPECT_EQ(copy.plain[1], 9.);
      EXPECT_EQ(copy.timings, whole.timings);
      EXPECT_EQ(copy.colour, Colour::blue);
      EXPECT_TRUE(copy.flag);
      Archive again = Archive::writer();
      again(copy);
      EXPECT_EQ(again.content(), writer.content());
    }



    TEST(Archive, EveryShorterContentIsRefused)
    {
      Whole   whole  = example();
      Archive writer = Archive::writer();
      writer(whole);
      for (std::size_t n = 0; n < writer.content().size(); ++n)
        {
          Archive reader = Archive::reader(writer.content().substr(0, n));
          Whole   copy;
          EXPECT_THROW(reader(copy), InputError) << n;
        }
    }



    TEST(Archive, AnImpossibleLengthIsRefusedWithoutMemory)
    {
      Archive writer = Archive::writer();
      writer.put(std::uint64_t(1) << 60);
      Archive             reader = Archive::reader(writer.content());
      std::vector<double> values;
      EXPECT_THROW(reader(values), InputError);
    }



    TEST(Archive, DescriptionTellsTypesNotValues)
    {
      const auto describe = [](auto value) {
        Archive archive = Archive::describer();
        archive(value);
        return archive.content();
      };
      EXPECT_EQ(describe(example()), describe(Whole()));
      EXPECT_EQ(describe(Part()), "{b4f8}");
      EXPECT_EQ(describe(std::vector<Part>(7)), "[{b4f8}]");
      EXPECT_NE(describe(1.), describe(1));
      EXPECT_NE(describe(1), describe(1L));
    }



    TEST(Archive, ChecksumIsThatOfFnv)
    {
      EXPECT_EQ(checksum(""), 0xcbf29ce484222325u);
      EXPECT_EQ(checksum("a"), 0xaf63dc4c8601ec8cu);
    }
  } // namespace
} // namespace hybrid::restart
