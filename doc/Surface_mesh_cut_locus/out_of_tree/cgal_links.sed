# references into the manual of CGAL
s|\\ref bgl_namedparameters "Named Parameters"|<a href="https://doc.cgal.org/latest/BGL/group__bgl__namedparameters.html">Named Parameters</a>|g
s|\\ref PkgSurfaceMeshShortestPath "\([^"]*\)"|<a href="https://doc.cgal.org/latest/Surface_mesh_shortest_path/index.html">\1</a>|g
s|\\ref PkgHeatMethod "\([^"]*\)"|<a href="https://doc.cgal.org/latest/Heat_method_3/index.html">\1</a>|g
s|\\ref PkgSurfaceMeshParameterization "\([^"]*\)"|<a href="https://doc.cgal.org/latest/Surface_mesh_parameterization/index.html">\1</a>|g
s|\\ref PkgPolygonMeshProcessing "\([^"]*\)"|<a href="https://doc.cgal.org/latest/Polygon_mesh_processing/index.html">\1</a>|g
s|\\ref PkgBGL "\([^"]*\)"|<a href="https://doc.cgal.org/latest/BGL/index.html">\1</a>|g
s|\\ref licensesGPL "GPL"|GPL-3.0-or-later|g
# O-notation, without LaTeX: powers and the logarithm
/[\\@]cgalBigO{/{
  s/[\\@]cgalBigO{\([^{}]*\)^{\([^{}]*\)}\([^{}]*\)}/<i>O<\/i>(\1<sup>\2<\/sup>\3)/g
  s/[\\@]cgalBigO{\([^{}^]*\)^\([0-9]\)\([^{}]*\)}/<i>O<\/i>(\1<sup>\2<\/sup>\3)/g
  s/[\\@]cgalBigO{\([^{}]*\)}/<i>O<\/i>(\1)/g
}
s/\\f\$2\\pi\\f\$/2\&pi;/g
