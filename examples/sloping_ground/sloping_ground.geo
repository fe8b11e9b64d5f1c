// A layer of sand on slanted rock under water, in metres.
DefineConstant[
  length    = {30.0, Name "Section/length, m"},
  thickness = {5.0, Name "Section/thickness of the layer at its upper side, m"},
  slope     = {0.08, Name "Section/slope of the ground, rise over run"},
  bedrock   = {0.12, Name "Section/slope of the rock, rise over run"}
];

// The upper side is on the left; the layer is thicker downhill where the rock is steeper than the ground.
Point(1) = {0, -thickness, 0};
Point(2) = {length, -thickness - bedrock * length, 0};
Point(3) = {length, -slope * length, 0};
Point(4) = {0, 0, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("sand") = {1};
Physical Curve("rock") = {1};
Physical Curve("downhill") = {2};
Physical Curve("ground") = {3};
Physical Curve("uphill") = {4};
