# cmake --install copies the headers and what find_package(Surface_mesh_cut_locus) needs.
include(CMakePackageConfigHelpers)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Surface_mesh_cut_locus)

install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include_np/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/Surface_mesh_cut_locus/named_parameters)
install(TARGETS Surface_mesh_cut_locus EXPORT Surface_mesh_cut_locusTargets)
install(EXPORT Surface_mesh_cut_locusTargets NAMESPACE CGAL:: DESTINATION ${config_folder})

configure_package_config_file(cmake/Surface_mesh_cut_locusConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/Surface_mesh_cut_locusConfigVersion.cmake
        DESTINATION ${config_folder})
