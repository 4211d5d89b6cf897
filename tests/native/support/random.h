// Numbers that look random and are the same on every machine: the standard library's distributions are not.
#pragma once

#include <cmath>
#include <cstdint>

namespace support {

/// xorshift64* (Vigna, "An experimental exploration of Marsaglia's xorshift generators, scrambled", 2016).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {}

    std::uint32_t next() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return static_cast<std::uint32_t>(state_ * 0x2545F4914F6CDD1Dull >> 32);
    }
    /// 0 to count - 1.
    std::uint32_t below(std::uint32_t count) { return next() % count; }
    bool coin() { return (next() >> 16 & 1) != 0; }
    /// 0 to 1, 1 excluded.
    double unit() { return next() * (1.0 / 4294967296.0); }
    double between(double low, double high) { return low + (high - low) * unit(); }

    /// A unit quaternion x, y, z, w, evenly spread (rejection in the four-dimensional ball).
    void rotation(float (&out)[4]) {
        double q[4];
        double length = 0.0;
        do {
            length = 0.0;
            for (double& part : q) {
                part = between(-1.0, 1.0);
                length += part * part;
            }
        } while (length > 1.0 || length < 1e-3);
        for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(q[i] / std::sqrt(length));
    }

private:
    std::uint64_t state_;
};

}  // namespace support
