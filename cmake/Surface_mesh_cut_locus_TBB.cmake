# Defines CGAL::TBB_support if TBB is there: what links it may pass CGAL::Parallel_tag.
if(NOT TARGET CGAL::TBB_support)
  find_package(TBB QUIET CONFIG) # its own configuration file: the module of CGAL 5.5 knows old versions only
  include(CGAL_TBB_support)
  if(NOT TARGET CGAL::TBB_support)
    message(STATUS "NOTICE: TBB (libtbb-dev) is not there: examples, tests and the program use one thread")
  endif()
endif()
