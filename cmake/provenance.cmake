# Facts about this build for the provenance of a report. The revision is asked for at build time, not at configure time.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type_upper)
string(JOIN " " rounding ${ORDO_ROUNDING})
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type_upper}} ${rounding}" build_flags)
set(build_facts ${PROJECT_BINARY_DIR}/generated/build_facts.hpp)
add_custom_target(ordo_build_facts
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${build_facts}
          -DVERSION=${PROJECT_VERSION} "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          "-DFLAGS=${build_flags}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
          "-DEIGEN=${Eigen3_VERSION}" "-DBOOST=${Boost_VERSION}" "-DGSL=${GSL_VERSION}" "-DJSON=${nlohmann_json_VERSION}" "-DFMT=${fmt_VERSION}"
          -P ${PROJECT_SOURCE_DIR}/cmake/write_build_facts.cmake
  BYPRODUCTS ${build_facts})
add_dependencies(ordo_reports ordo_build_facts)
target_include_directories(ordo_reports PRIVATE ${PROJECT_BINARY_DIR}/generated)
