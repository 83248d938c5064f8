"""Geometries of films with more than two electrodes."""

# A film whose upper electrode has two parts.
TWO_PARTS = """Point(1) = {0, 0, 0};
l1[] = Extrude {2.5, 0, 0} { Point{1}; Layers{1}; };
l2[] = Extrude {2.5, 0, 0} { Point{l1[0]}; Layers{1}; };
a1[] = Extrude {0, 5, 0} { Line{l1[1]}; Layers{1}; Recombine; };
a2[] = Extrude {0, 5, 0} { Line{l2[1]}; Layers{1}; Recombine; };
b1[] = Extrude {0, 0, 1} { Surface{a1[1]}; Layers{1}; Recombine; };
b2[] = Extrude {0, 0, 1} { Surface{a2[1]}; Layers{1}; Recombine; };
Physical Volume("film") = {b1[1], b2[1]};
Physical Surface("bottom") = {a1[1], a2[1]};
Physical Surface("left") = b1[0];
Physical Surface("right") = b2[0];
Physical Surface("x2_min") = {b1[2], b2[2]};
Physical Surface("x1_min") = b1[5];
"""

# Three layers with electrodes between them.
THREE_LAYERS = """Point(1) = {0, 0, 0};
line[] = Extrude {2, 0, 0} { Point{1}; Layers{1}; };
area[] = Extrude {0, 2, 0} { Line{line[1]}; Layers{1}; Recombine; };
a[] = Extrude {0, 0, 0.3} { Surface{area[1]}; Layers{1}; Recombine; };
b[] = Extrude {0, 0, 0.5} { Surface{a[0]}; Layers{1}; Recombine; };
c[] = Extrude {0, 0, 0.2} { Surface{b[0]}; Layers{1}; Recombine; };
Physical Volume("film") = {a[1], b[1], c[1]};
Physical Surface("bottom") = area[1];
Physical Surface("s12") = a[0];
Physical Surface("s23") = b[0];
Physical Surface("top") = c[0];
Physical Surface("x1_min") = Surface In BoundingBox {-1e-6, -1e-6, -1e-6, 1e-6, 3, 2};
Physical Surface("x1_max") = Surface In BoundingBox {2-1e-6, -1e-6, -1e-6, 3, 3, 2};
Physical Surface("x2_min") = Surface In BoundingBox {-1e-6, -1e-6, -1e-6, 3, 1e-6, 2};
Physical Surface("x2_max") = Surface In BoundingBox {-1e-6, 2-1e-6, -1e-6, 3, 3, 2};
"""
