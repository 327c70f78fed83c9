# cmake --install copies the headers, the compiled library, and what find_package(Surface_mesh_cut_locus) and pkg-config
# need.
include(CMakePackageConfigHelpers)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Surface_mesh_cut_locus)

install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include_np/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/Surface_mesh_cut_locus/named_parameters)
set_target_properties(Surface_mesh_cut_locus PROPERTIES EXCLUDE_FROM_ALL OFF) # what is installed is built
install(TARGETS Surface_mesh_cut_locus Surface_mesh_cut_locus_header_only EXPORT Surface_mesh_cut_locusTargets)
install(EXPORT Surface_mesh_cut_locusTargets NAMESPACE CGAL:: DESTINATION ${config_folder})

configure_package_config_file(cmake/Surface_mesh_cut_locusConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfigVersion.cmake
        DESTINATION ${config_folder})

set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH path_to_prefix /prefix/${pkgconfig_folder} /prefix)
configure_file(cmake/surface_mesh_cut_locus.pc.in surface_mesh_cut_locus.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/surface_mesh_cut_locus.pc DESTINATION ${pkgconfig_folder})
