// A plate of 20 x 20 x 1 mm with a hole of 4 mm radius in its middle, as a CAD program left it, in mm.
DefineConstant[ size = {4, Name "size"} ];
SetFactory("OpenCASCADE");
Merge "plate_with_hole.step";
Mesh.MeshSizeMax = size;
Mesh.ElementOrder = 2;
Physical Volume("plate") = Volume{:};
Physical Surface("bottom") = Surface In BoundingBox{-1, -1, -0.1, 21, 21, 0.1};
Physical Surface("top") = Surface In BoundingBox{-1, -1, 0.9, 21, 21, 1.1};
