#pragma once
// Catch2 2.13 (Debian 12) and 3.x under one name. Tests include this and nothing else of Catch2.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>   // brings Approx into the global namespace by itself
namespace ordo_test_shim {
inline auto ContainsSubstring(const std::string& text) { return Catch::Matchers::Contains(text); }
}  // namespace ordo_test_shim
using ordo_test_shim::ContainsSubstring;
#endif
