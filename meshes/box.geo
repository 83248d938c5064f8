// A block [0,L1] x [0,L2] x [0,L3] in mm of n1 x n2 x n3 hexahedra.
// Region: film. Surfaces: x1_min, x1_max, x2_min, x2_max, bottom (x3 = 0), top (x3 = L3).
DefineConstant[
  L1 = {5, Name "L1"}, L2 = {5, Name "L2"}, L3 = {1, Name "L3"},
  n1 = {2, Name "n1"}, n2 = {2, Name "n2"}, n3 = {2, Name "n3"}
];
Point(1) = {0, 0, 0};
line[] = Extrude {L1, 0, 0} { Point{1}; Layers{n1}; };
area[] = Extrude {0, L2, 0} { Line{line[1]}; Layers{n2}; Recombine; };
body[] = Extrude {0, 0, L3} { Surface{area[1]}; Layers{n3}; Recombine; };
Physical Volume("film") = body[1];
Physical Surface("bottom") = area[1];
Physical Surface("top") = body[0];
Physical Surface("x2_min") = body[2];
Physical Surface("x1_max") = body[3];
Physical Surface("x2_max") = body[4];
Physical Surface("x1_min") = body[5];
