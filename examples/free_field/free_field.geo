// An embankment on two layers of sand over rock, in metres. The loose layer is thicker on the right: level ground
// on both sides, but not the same. The ground is at y = 0.
DefineConstant[
  height = {4.0, Name "Embankment/height, m"},
  crest  = {4.0, Name "Embankment/width of the crest, m"},
  slope  = {2.0, Name "Embankment/run over rise of the slopes"},
  depth  = {10.0, Name "Ground/depth to rock, m"},
  left   = {4.0, Name "Ground/thickness of the loose sand on the left, m"},
  right  = {7.0, Name "Ground/thickness of the loose sand on the right, m"},
  margin = {20.0, Name "Ground/width beside the embankment, m"}
];
toe = crest / 2 + slope * height;
side = toe + margin;

Point(1) = {-side, -depth, 0};
Point(2) = {side, -depth, 0};
Point(3) = {side, -right, 0};
Point(4) = {side, 0, 0};
Point(5) = {toe, 0, 0};
Point(6) = {crest / 2, height, 0};
Point(7) = {-crest / 2, height, 0};
Point(8) = {-toe, 0, 0};
Point(9) = {-side, 0, 0};
Point(10) = {-side, -left, 0};
Point(11) = {-toe, -left, 0};   // the layers are level beside the embankment
Point(12) = {toe, -right, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 10};
Line(10) = {10, 1};
Line(11) = {10, 11};
Line(12) = {11, 12};
Line(13) = {12, 3};
Line(14) = {8, 5};

Curve Loop(1) = {1, 2, -13, -12, -11, 10};
Plane Surface(1) = {1};
Curve Loop(2) = {11, 12, 13, 3, 4, -14, 8, 9};
Plane Surface(2) = {2};
Curve Loop(3) = {14, 5, 6, 7};
Plane Surface(3) = {3};

Physical Surface("dense") = {1};
Physical Surface("loose") = {2};
Physical Surface("embankment") = {3};
Physical Curve("rock") = {1};
Physical Curve("right") = {2, 3};
Physical Curve("left") = {9, 10};
Physical Curve("surface") = {4, 8};
Physical Curve("slopes") = {5, 6, 7};
