//! Books, papers and stationery.

pub(in crate::object) mod desk;
mod paper;
mod print;
mod title;
mod volume;
mod writing;

use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("book", 12, volume::book),
    indoor("novel", 16, volume::book),
    indoor("textbook", 10, volume::book),
    indoor("cookbook", 8, volume::book),
    indoor("picture_book", 6, volume::book),
    indoor("photo_album", 4, volume::book),
    indoor("diary", 4, volume::book),
    indoor("notebook", 5, volume::notebook),
    indoor("magazine", 10, print::magazine),
    indoor("newspaper", 4, print::newspaper),
    indoor("calendar", 3, print::calendar),
    indoor("map", 2, print::map),
    indoor("bookmark", 1, print::bookmark),
    indoor("passport", 1, volume::passport),
    indoor("paper", 2, paper::sheets),
    indoor("notes", 1, paper::sheets),
    indoor("homework", 1, paper::sheets),
    indoor("form", 1, paper::sheets),
    indoor("document", 2, paper::sheets),
    indoor("bills", 1, paper::sheets),
    indoor("check", 1, paper::sheets),
    indoor("banknote", 1, paper::sheets),
    indoor("notepad", 2, paper::pad),
    indoor("sticky_notes", 2, paper::pad),
    indoor("mail", 3, paper::envelope),
    indoor("envelope", 2, paper::envelope),
    indoor("greeting_card", 2, paper::card),
    indoor("stamp", 1, paper::card),
    indoor("credit_card", 1, paper::card),
    indoor("coin", 2, paper::coin),
    indoor("pencil", 2, writing::stick),
    indoor("pen", 2, writing::stick),
    indoor("marker", 2, writing::stick),
    indoor("crayon", 1, writing::stick),
    indoor("paintbrush", 1, writing::stick),
    indoor("laser_pointer", 1, writing::stick),
    indoor("eraser", 1, writing::eraser),
    indoor("ruler", 1, writing::ruler),
    indoor("pencil_sharpener", 1, writing::sharpener),
    indoor("pencil_case", 2, desk::pencil_case),
    indoor("pencil_holder", 2, desk::pencil_holder),
    indoor("stapler", 2, desk::stapler),
    indoor("hole_punch", 1, desk::hole_punch),
    indoor("paper_clip", 1, writing::paper_clip),
    indoor("push_pin", 1, writing::push_pin),
    indoor("rubber_band", 1, writing::rubber_band),
    indoor("tape", 2, desk::tape),
    indoor("duct_tape", 2, desk::tape),
    indoor("glue", 2, desk::glue),
    indoor("scissors", 2, desk::scissors),
    indoor("folder", 3, desk::folder),
    indoor("paper_tray", 2, desk::paper_tray),
    indoor("clipboard", 2, desk::clipboard),
    indoor("calculator", 2, desk::calculator),
    indoor("mousepad", 2, desk::mousepad),
    indoor("paper_shredder", 2, desk::paper_shredder),
];
