# Writes OUT, and only when its text changes, so that an unchanged checkout rebuilds nothing.
set(revision unknown)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --match=
                OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed EQUAL 0)
  set(revision ${described})
endif()
set(text "#pragma once
namespace ordo::reports::build_facts {
inline constexpr const char* version = \"${VERSION}\";
inline constexpr const char* revision = \"${revision}\";
inline constexpr const char* compiler = \"${COMPILER}\";
inline constexpr const char* flags = \"${FLAGS}\";
inline constexpr const char* build_type = \"${BUILD_TYPE}\";
inline constexpr const char* eigen = \"${EIGEN}\";
inline constexpr const char* boost = \"${BOOST}\";
inline constexpr const char* gsl = \"${GSL}\";
inline constexpr const char* json = \"${JSON}\";
inline constexpr const char* fmt = \"${FMT}\";
}
")
if(EXISTS ${OUT})
  file(READ ${OUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE ${OUT} "${text}")
endif()
