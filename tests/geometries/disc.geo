// A disc in the plane of x1 and x3, radius 10 mm, which gmsh meshes with triangles.
DefineConstant[ size = {4, Name "size"} ];
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 10};
Rotate { {1, 0, 0}, {0, 0, 0}, Pi/2 } { Surface{1}; }
Mesh.MeshSizeMax = size;
Mesh.ElementOrder = 2;
Physical Surface("disc") = {1};
Physical Curve("edge") = Curve{:};
