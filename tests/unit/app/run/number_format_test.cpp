#include "app/run/number_format.hpp"

#include <gtest/gtest.h>

namespace quicksand {

TEST(ShortNumber, HasFewDigitsAndAnExponentOnlyWhereItIsShorter)
{
    EXPECT_EQ(short_number(0.0421), "0.0421");
    EXPECT_EQ(short_number(168.4, 2), "170");
    EXPECT_EQ(short_number(-5123.0, 2), "-5100");
    EXPECT_EQ(short_number(2.6e-6), "2.6e-6");
    EXPECT_EQ(short_number(1.9e6), "1.9e6");
    EXPECT_EQ(short_number(12345.0), "1.23e4");
}

TEST(ThreadsText, CountsOneAndMany)
{
    EXPECT_EQ(threads_text(1), "1 thread");
    EXPECT_EQ(threads_text(2), "2 threads");
}

} // namespace quicksand
