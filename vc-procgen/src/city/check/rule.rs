//! The rules of a city.

use std::fmt;

macro_rules! rules {
    ($($name:ident, $number:literal, $words:literal;)*) => {
        /// A rule that plans keep. Rules about one thing share a number; numbers that are missing are those of rules about turning
        /// vehicles, levels and rooms, which plans are not checked for.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum CityRule {
            $(#[doc = concat!("Broken by: ", $words, ".")] $name,)*
        }

        impl CityRule {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its number in the list of rules.
            pub fn number(self) -> u8 {
                match self { $(Self::$name => $number,)* }
            }

            /// The words for what breaks it, with the limit.
            pub fn words(self) -> &'static str {
                match self { $(Self::$name => $words,)* }
            }
        }
    };
}

rules! {
    StreetsCross, 1, "streets that cross without a junction, m from an end";
    StreetsCutOff, 1, "streets that cannot be reached from the others, junctions";
    DeadEnd, 1, "dead end longer than 60 m";
    ShortArm, 1, "arm of a junction shorter than 12 m";
    SharpAngle, 1, "angle between streets under 40 degrees";
    LandUncovered, 2, "land that nothing covers or that is covered twice, m²";
    ParcelsOverlap, 2, "parcels that overlap, m²";
    LaneOnPavement, 2, "carriageway within a block's kerb, m beyond its middle";
    PavementOffGround, 2, "pavement outside the ground between kerb and building line, m along its lane";
    WaterOnLand, 2, "water on a block, m²";
    BuildingOffParcel, 3, "building beyond its parcel, m";
    WingsOverlap, 3, "wings of buildings that overlap, m²";
    NoFrontage, 4, "parcel with less than 3 m on a street";
    FarFromStreet, 4, "entrance more than 45 m from a carriageway";
    NoEntrance, 5, "building without an entrance";
    EntranceOffPavement, 5, "entrance that no pavement of the walkable network reaches, m";
    EntranceBlocked, 5, "thing within 1.5 m before an entrance, m";
    PavementsCutOff, 8, "pavements that cannot be reached from the others, m";
    NarrowPavement, 8, "pavement with less than 1.5 m clear";
    NarrowPavements, 8, "share of pavements with 1.8 m clear under 95 %";
    CrossingMissing, 9, "arm of a junction with lights without a crossing, ramps and lights for people";
    StopLineBeyond, 10, "stop line that is not before its crossing, m";
    SignalHidden, 10, "lights that cannot be seen from 60 m, m to what hides them";
    SignalMissing, 10, "approach to lights without a head";
    PhasesConflict, 11, "phase of lights in which movements conflict, or people get no time";
    ShortGreen, 11, "time for people shorter than the width at 1.07 m/s and 7 s, s";
    ViewHidden, 12, "view of who gives way that is not free, m² hidden";
    SignMissing, 14, "give-way line or one-way street without its sign";
    ItemNearKerb, 15, "thing less than 0.45 m from the kerb";
    ItemOffPavement, 15, "thing that is not on its pavement, m";
    ItemFacesAway, 15, "thing that does not face its street, cosine";
    ItemsOverlap, 15, "things nearer than their hulls, m";
    TreeAtFacade, 15, "tree within 2.5 m of a facade, m";
    TreeAtLamp, 15, "tree within 4.5 m of a lamp, m";
    CarOutsideBay, 16, "parked car outside the bays, m";
    CarDoorsShut, 16, "parked car with less than 0.6 m for doors on both sides";
    CarsOverlap, 16, "parked cars that overlap, m²";
    BusStopsApart, 17, "bus stops of a main street more than 500 m apart";
    StationCutOff, 17, "station that no pavement reaches, m";
    WaterOpen, 18, "water without a railing, or shore without a way down";
    PavementDark, 19, "pavement farther from a lamp than 0.6 of their distance, m";
    PlaceMissing, 20, "kind of place that the residents need and nobody has, residents";
    PlaceCutOff, 20, "place that cannot be walked to";
}

impl fmt::Display for CityRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.words())
    }
}
