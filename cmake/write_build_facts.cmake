# Writes OUT, and only when its text changes, so that an unchanged checkout rebuilds nothing.
set(revision unknown)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --match=
                OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed EQUAL 0)
  set(revision ${described})
endif()
# Digest of the given files and of all sources in the given folders: 16 hexadecimal digits.
function(digest_of result)
  set(all "")
  foreach(part IN LISTS ARGN)
    if(IS_DIRECTORY ${SOURCE}/${part})
      file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/${part}/*.cpp ${SOURCE}/${part}/*.hpp)
    else()
      set(files ${part})
    endif()
    list(SORT files)
    foreach(file IN LISTS files)
      file(SHA256 ${SOURCE}/${file} digest)
      string(APPEND all "${file} ${digest}\n")
    endforeach()
  endforeach()
  string(SHA256 digest "${all}")
  string(SUBSTRING ${digest} 0 16 digest)
  set(${result} ${digest} PARENT_SCOPE)
endfunction()
# What figures of a run follow from, a room each; how they are judged and shown is no part of it.
digest_of(sources_build CMakeLists.txt)
digest_of(sources_core core)
digest_of(sources_solvers solvers)
digest_of(sources_oracles oracles)
digest_of(sources_engine studies/engine)
digest_of(sources_scenes studies/scenes)
digest_of(sources_amplification studies/amplification)
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
inline constexpr const char* sources_build = \"${sources_build}\";
inline constexpr const char* sources_core = \"${sources_core}\";
inline constexpr const char* sources_solvers = \"${sources_solvers}\";
inline constexpr const char* sources_oracles = \"${sources_oracles}\";
inline constexpr const char* sources_engine = \"${sources_engine}\";
inline constexpr const char* sources_scenes = \"${sources_scenes}\";
inline constexpr const char* sources_amplification = \"${sources_amplification}\";
}
")
if(EXISTS ${OUT})
  file(READ ${OUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE ${OUT} "${text}")
endif()
