// An eighth of a spherical shell around the origin, radii R to R+H in mm: three patches of n x n
// hexahedra around the corner (1,1,1), nr of them through the wall. Region: wall. Surfaces: inner,
// outer, x1_min (x1 = 0), x2_min, x3_min. Points on the x1 axis: inner_end, outer_end.
DefineConstant[
  R = {10, Name "R"}, H = {1, Name "H"}, n = {2, Name "n", Min 1, Max 500, Step 1},
  nr = {1, Name "nr", Min 1, Max 500, Step 1}
];
Point(100) = {0, 0, 0};
For s In {0:1}
  r = R + s*H;
  p = 10*s;
  Point(p+1) = {r, 0, 0};
  Point(p+2) = {0, r, 0};
  Point(p+3) = {0, 0, r};
  Point(p+4) = {0, r/Sqrt(2), r/Sqrt(2)};
  Point(p+5) = {r/Sqrt(2), 0, r/Sqrt(2)};
  Point(p+6) = {r/Sqrt(2), r/Sqrt(2), 0};
  Point(p+7) = {r/Sqrt(3), r/Sqrt(3), r/Sqrt(3)};
EndFor

// Arcs: around the edge of the eighth, then the spokes to its middle.
from[] = {1, 6, 2, 4, 3, 5, 6, 4, 5};
to[] = {6, 2, 4, 3, 5, 1, 7, 7, 7};
For s In {0:1}
  For k In {0:8}
    Circle(100*s+k+1) = {10*s+from[k], 100, 10*s+to[k]};
  EndFor
  // Patches around the points 1, 2 and 3.
  Curve Loop(10*s+1) = {100*s+1, 100*s+7, -(100*s+9), 100*s+6};
  Curve Loop(10*s+2) = {100*s+3, 100*s+8, -(100*s+7), 100*s+2};
  Curve Loop(10*s+3) = {100*s+5, 100*s+9, -(100*s+8), 100*s+4};
  For k In {1:3}
    Surface(10*s+k) = {10*s+k} In Sphere {100};
  EndFor
EndFor

// Through the wall: lines at the points, sectors at the arcs.
For k In {1:7}
  Line(200+k) = {k, 10+k};
EndFor
For k In {0:8}
  Curve Loop(100+k+1) = {k+1, 200+to[k], -(100+k+1), -(200+from[k])};
  Plane Surface(100+k+1) = {100+k+1};
EndFor
Surface Loop(1) = {1, 11, 101, 107, 109, 106};
Surface Loop(2) = {2, 12, 103, 108, 107, 102};
Surface Loop(3) = {3, 13, 105, 109, 108, 104};
For k In {1:3}
  Volume(k) = {k};
EndFor

Transfinite Curve {1:9, 101:109} = n + 1;
Transfinite Curve {201:207} = nr + 1;
Transfinite Surface {1:3, 11:13, 101:109};
Recombine Surface {1:3, 11:13, 101:109};
Transfinite Volume {1:3};
Physical Volume("wall") = {1:3};
Physical Surface("inner") = {1:3};
Physical Surface("outer") = {11:13};
Physical Surface("x3_min") = {101, 102};
Physical Surface("x1_min") = {103, 104};
Physical Surface("x2_min") = {105, 106};
Physical Point("inner_end") = 1;
Physical Point("outer_end") = 11;
