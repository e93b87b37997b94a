// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/output/base64.h>

namespace hybrid::output
{
  namespace
  {
    // RFC 4648, section 10.
    TEST(Base64, FillsUpTheLastGroup)
    {
      const char *known[][2] = {{"", ""},
                                {"f", "Zg=="},
                                {"fo", "Zm8="},
                                {"foo", "Zm9v"},
                                {"foob", "Zm9vYg=="},
                                {"fooba", "Zm9vYmE="},
                                {"foobar", "Zm9vYmFy"}};
      for (const auto &[bytes, code] : known)
        {
          std::string text = "=";
          append_base64(text, bytes, std::string(bytes).size());
          EXPECT_EQ(text, "=" + std::string(code));
        }
    }



    TEST(Base64, TakesBytesOfAnyValue)
    {
      const unsigned char bytes[] = {0xff, 0xfe, 0x00, 0xfb};
      std::string         text;
      append_base64(text, bytes, sizeof(bytes));
      EXPECT_EQ(text, "//4A+w==");
    }
  } // namespace
} // namespace hybrid::output
