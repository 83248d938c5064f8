// An octant of a spherical shell around the origin, radii 1 and 2 mm.
DefineConstant[ size = {0.7, Name "size"}, order = {2, Name "order", Min 1, Max 2, Step 1},
  incomplete = {0, Name "incomplete", Min 0, Max 1, Step 1}
];
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 2, 0, Pi/2, Pi/2};
Sphere(2) = {0, 0, 0, 1, 0, Pi/2, Pi/2};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Mesh.MeshSizeMax = size;
Mesh.MeshSizeMin = size;
Mesh.ElementOrder = order;
Mesh.SecondOrderIncomplete = incomplete;
inner[] = Surface In BoundingBox{-0.1, -0.1, -0.1, 1.1, 1.1, 1.1};
flat[] = Surface In BoundingBox{-0.1, -0.1, -0.1, 2.1, 2.1, 0.1};
flat[] += Surface In BoundingBox{-0.1, -0.1, -0.1, 2.1, 0.1, 2.1};
flat[] += Surface In BoundingBox{-0.1, -0.1, -0.1, 0.1, 2.1, 2.1};
outer[] = Surface{:};
outer[] -= inner[];
outer[] -= flat[];
Physical Volume("shell") = {3};
Physical Surface("inner") = inner[];
Physical Surface("outer") = outer[];
