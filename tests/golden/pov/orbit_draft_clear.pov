// A hill
//
// A landscape by Cydonia. In the folder of this file, with POV-Ray 3.7:
//
//     povray shot.ini
//
// It needs heights.png, ground.png, sky_visibility.png and shot.sky.exr beside it, and
// draws shot.exr: linear light, Rec.709 primaries, no exposure.

#version 3.7;

// The land, in metres. Its heights stand at the centres of square cells.
#declare LandWidth  = 1280; // west to east
#declare LandDepth  = 1280; // south to north
#declare Spacing    = 20; // from one height to the next
#declare BaseHeight = 4; // the lowest ground
#declare Relief     = 995; // from there to the highest

// One POV-Ray unit in metres.
#declare Unit = 10;

// From metres east, north and up of the land's south-west corner to POV-Ray's space, where
// x is east, y up and z north.
#macro Towards(East, North, Up) (<East, Up, North>) #end
#macro At(East, North, Up) (Towards(East, North, Up) / Unit) #end

#declare LandSize = max(LandWidth, LandDepth);
#declare Middle = At(LandWidth / 2, LandDepth / 2, BaseHeight + Relief / 2);

// The sun, in degrees: clockwise from north, and above the horizon. The light's colours
// below and the sky's image belong to this height; 1 is what a white sheet sends back.
#declare SunAzimuth   = 305;
#declare SunElevation = 25;
#declare SunLight     = rgb <0.74, 0.5847, 0.4077>;
#declare SkyLight     = rgb <0.07031, 0.09493, 0.141>; // of the whole sky, on level ground
#declare SkyFill      = 1; // above 1 opens the shadows; the visible sky stays

global_settings {
    assumed_gamma 1.0
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location At(640, -2646.12862, 1540.76809)
    sky Towards(0, 0, 1)
    up y right image_width / image_height * x
    angle 30 // across the frame's width
    look_at At(640, 640, 344.715088)
}

#declare ToSun = Towards(
    sin(radians(SunAzimuth)) * cos(radians(SunElevation)),
    cos(radians(SunAzimuth)) * cos(radians(SunElevation)),
    sin(radians(SunElevation)));
#declare SunDistance = 100 * LandSize / Unit;
light_source {
    Middle + SunDistance * ToSun
    color SunLight
    parallel point_at Middle
}

// The whole sky around the land, the sun's disc left out.
sky_sphere {
    pigment {
        image_map { exr "shot.sky.exr" map_type 1 interpolate 2 }
    }
}

// The ground's colour covers the cells, draped from above.
#declare FromAbove = transform { rotate 90 * x scale At(LandWidth, LandDepth, Unit) }
#declare GroundColour = pigment {
    image_map { png "ground.png" gamma srgb interpolate 2 }
}
// Sunlight is traced; skylight is what sky_visibility.png leaves of it: white is a place
// that sees the whole sky, black one that sees none.
#declare Ground = texture {
    image_pattern { png "sky_visibility.png" gamma 1.0 interpolate 2 }
    texture_map {
        [0 pigment { GroundColour } ]
        [1 pigment { GroundColour } finish { emission SkyLight * SkyFill } ]
    }
    transform { FromAbove }
};

// The heights are corners of the surface, which so ends half a cell inside the land.
#declare Land = height_field {
    png "heights.png" gamma 1.0
    scale At(LandWidth - Spacing, LandDepth - Spacing, Relief)
    translate At(Spacing / 2, Spacing / 2, BaseHeight)
}
object { Land texture { Ground } }

// Around the land: its sides, and level country of the ground's mean colour at the height
// of the lowest border, so that no view ends in nothing.
#declare OutskirtsHeight = 4;
#declare ColourAt = function { pigment { GroundColour } }
#declare MeanColour = rgb 0;
#for (I, 0, 31)
    #for (J, 0, 31)
        #declare MeanColour =
            MeanColour + ColourAt((I + 0.5) / 32, (J + 0.5) / 32, 0) / 1024;
    #end
#end
#declare MeanGround = texture { pigment { color MeanColour } finish { emission SkyLight * SkyFill } }
#declare Sides = box {
    At(Spacing / 2, Spacing / 2, BaseHeight) + 1e-4,
    At(LandWidth - Spacing / 2, LandDepth - Spacing / 2, BaseHeight + 2 * Relief) - 1e-4
    clipped_by { Land }
    texture { MeanGround }
    hollow // haze fills the box too
}
object { Sides }
#declare Around = 0; // lands on each side of the land
plane {
    y, OutskirtsHeight / Unit
    clipped_by {
        box {
            At(Spacing / 2 - Around * (LandWidth - Spacing),
               Spacing / 2 - Around * (LandDepth - Spacing), -1e6),
            At(LandWidth - Spacing / 2 + Around * (LandWidth - Spacing),
               LandDepth - Spacing / 2 + Around * (LandDepth - Spacing), 1e6)
            inverse
        }
    }
    texture { MeanGround }
}
