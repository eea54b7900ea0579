//! Invented titles of books and magazines.

use crate::solid::Build;

const FIRST: [&str; 24] = [
    "The Silent",
    "A Winter",
    "The Last",
    "Beyond the",
    "The Blue",
    "Letters from the",
    "The Glass",
    "Under the",
    "The Hidden",
    "A Quiet",
    "The Wandering",
    "Songs of the",
    "The Seventh",
    "The Paper",
    "North of the",
    "The Crooked",
    "A Distant",
    "The Salt",
    "The Amber",
    "Children of the",
    "The Hollow",
    "The Long",
    "Return to the",
    "The Burning",
];

const SECOND: [&str; 24] = [
    "Harbour",
    "Garden",
    "Orchard",
    "Lighthouse",
    "River",
    "Mountain",
    "Letter",
    "Station",
    "Forest",
    "Mirror",
    "Island",
    "Clockmaker",
    "Voyage",
    "Meadow",
    "Tower",
    "Bridge",
    "Summer",
    "Cartographer",
    "Sea",
    "Valley",
    "Sparrow",
    "House",
    "Road",
    "Winter",
];

const SUBJECTS: [&str; 16] = [
    "Algebra",
    "Organic Chemistry",
    "World History",
    "Mechanics",
    "Botany",
    "Economics",
    "Geometry",
    "Astronomy",
    "Statistics",
    "Thermodynamics",
    "Philosophy",
    "Anatomy",
    "Linguistics",
    "Geology",
    "Programming",
    "Music Theory",
];

const KINDS: [&str; 6] =
    ["Principles of", "Introduction to", "Foundations of", "Exercises in", "Essential", "A Course in"];

const MEALS: [&str; 10] =
    ["Soups", "Bread", "Pasta", "Summer Salads", "Cakes", "Vegetables", "Stews", "Breakfast", "Pies", "Noodles"];

const TABLES: [&str; 6] = ["The Book of", "Simple", "Everyday", "Grandmother's", "Fifty", "The Joy of"];

const HEROES: [&str; 10] =
    ["Bear", "Otter", "Little Owl", "Captain Mouse", "Fox", "Hedgehog", "Penguin", "Whale", "Moon", "Kite"];

const DEEDS: [&str; 8] = [
    "Learns to Swim",
    "Goes Fishing",
    "Cannot Sleep",
    "Finds a Friend",
    "Builds a Boat",
    "and the Storm",
    "Moves House",
    "Counts to Ten",
];

const PAPERS: [&str; 10] = [
    "Homes",
    "Garden Week",
    "The Observer",
    "Rail & Trail",
    "Atelier",
    "Kitchen",
    "Orbit",
    "Pulse",
    "Travel",
    "Design",
];

/// Names the asset by an invented title that suits its class.
pub(super) fn entitle(b: &mut Build<'_>) {
    let (first, second): (&[&str], &[&str]) = match b.class {
        "textbook" => (&KINDS, &SUBJECTS),
        "cookbook" => (&TABLES, &MEALS),
        "picture_book" => (&HEROES, &DEEDS),
        "magazine" | "newspaper" => (&PAPERS, &["No. 3", "No. 8", "No. 12", "Spring", "Summer", "Autumn", "Winter"]),
        "diary" | "photo_album" | "notebook" => (&["Notes", "Memories", "Journal", "Days"], &["I", "II", "III", "IV"]),
        _ => (&FIRST, &SECOND),
    };
    let title = [b.one_of(first), b.one_of(second)].join(" ");
    b.name(&title);
}
