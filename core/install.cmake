# SPDX-License-Identifier: MIT
# What is installed: the library, its public headers, a CMake package and a pkg-config file, both
# relocatable. (The program and its manual page: tools/CMakeLists.txt.)
include(CMakePackageConfigHelpers)

# The public headers; everything a public header includes is one too (tests/guard/headers sees to it).
set(SCHULER_PUBLIC_HEADERS
  core/api.h core/dateline.h core/document.h core/earth.h core/embedded.h core/error.h core/geographic.h core/gravity.h core/isa.h core/lanes.h core/mooring.h
  core/normal.h core/overlays.h core/path.h core/random.h core/schema.h core/trajectory.h core/truth.h core/truth_nodes.h core/units.h core/vec.h
  mechanization/algorithms.h mechanization/aligner.h mechanization/alignment.h mechanization/mechanization.h mechanization/vertical.h
  scenarios/bench.h scenarios/characterize.h scenarios/covariance.h scenarios/csv.h scenarios/data_tables.h scenarios/digits.h scenarios/faults.h scenarios/gallery.h
  scenarios/growth.h scenarios/growth_text.h scenarios/identify.h scenarios/metrics.h scenarios/motion_extent.h scenarios/navigate.h scenarios/netcdf.h scenarios/paired.h
  scenarios/recording.h scenarios/result_file.h scenarios/result_netcdf.h scenarios/scenario.h scenarios/simulation.h scenarios/solve.h scenarios/source_count.h
  scenarios/source_size.h scenarios/trajectory_file.h
  sensors/allan.h sensors/allan_fit.h sensors/catalog.h sensors/chain.h sensors/chi_square.h sensors/markov.h sensors/markov_filter.h sensors/markov_integral.h
  sensors/model.h sensors/mounting.h sensors/optics.h sensors/params.h sensors/pendulum.h sensors/plugin.h sensors/plugins.h sensors/processes.h sensors/quantizer.h
  sensors/response.h sensors/setup.h sensors/spectrum.h sensors/stand.h sensors/temperature.h sensors/terms.h sensors/walk.h sensors/white.h)

install(TARGETS schuler EXPORT schuler-targets)
foreach(header IN LISTS SCHULER_PUBLIC_HEADERS)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/schuler/${folder})
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/core/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/schuler/core)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(SCHULER_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/schuler)
install(EXPORT schuler-targets NAMESPACE schuler:: DESTINATION ${SCHULER_CMAKE_DIR})
configure_package_config_file(core/schuler-config.cmake.in schuler-config.cmake
  INSTALL_DESTINATION ${SCHULER_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor release may break what programs rely on.
write_basic_package_version_file(schuler-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/schuler-config.cmake
  ${PROJECT_BINARY_DIR}/schuler-config-version.cmake DESTINATION ${SCHULER_CMAKE_DIR})

# From where the .pc file lies to the prefix, so that an installed tree can be moved.
file(RELATIVE_PATH SCHULER_PC_TO_PREFIX
  /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(core/schuler.pc.in schuler.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/schuler.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
