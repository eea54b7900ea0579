//! Decoration: vases, candles, pictures, mirrors, sculptures, clocks, boxes and
//! baskets, jewelry.

mod boxes;
mod candle;
pub(in crate::object) mod clock;
mod frame;
mod jewelry;
mod mirror;
mod ornament;
pub(in crate::object) mod picture;
mod vase;

use super::rest::settled;
use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("vase", 12, vase::vase),
    indoor("floor_vase", 5, vase::vase),
    indoor("centerpiece", 4, vase::centerpiece),
    indoor("candle", 9, candle::candle),
    indoor("tealight", 2, candle::tealight),
    indoor("candlestick", 5, candle::candlestick),
    indoor("frame", 5, frame::frame),
    indoor("photo_frame", 6, frame::frame),
    indoor("wall_picture_frame", 4, frame::frame),
    indoor("digital_photo_frame", 2, frame::frame),
    indoor("picture", 4, frame::print),
    indoor("painting", 10, frame::frame),
    indoor("poster", 6, frame::print),
    indoor("drawing", 3, frame::print),
    indoor("tapestry", 3, frame::tapestry),
    indoor("mirror", 8, mirror::wall),
    indoor("standing_mirror", 4, mirror::standing),
    indoor("hand_mirror", 4, mirror::hand),
    indoor("sculpture", 8, ornament::sculpture),
    indoor("figurine", 6, ornament::figurine),
    indoor("wreath", 3, ornament::wreath),
    indoor("christmas_tree", 3, ornament::christmas_tree),
    indoor("bookend", 3, ornament::bookend),
    indoor("piggy_bank", 2, ornament::piggy_bank),
    indoor("aquarium", 3, ornament::aquarium),
    indoor("aroma_diffuser", 2, ornament::diffuser),
    indoor("ashtray", 2, ornament::ashtray),
    indoor("globe", 3, ornament::globe),
    indoor("clock", 5, clock::clock),
    indoor("alarm_clock", 6, clock::alarm),
    indoor("wall_clock", 8, clock::wall),
    indoor("box", 5, boxes::carton),
    indoor("cardboard_box", 4, boxes::carton),
    indoor("storage_box", 4, boxes::storage),
    indoor("gift_box", 4, boxes::gift),
    indoor("basket", 6, boxes::basket),
    indoor("crate", 3, boxes::crate_box),
    indoor("laundry_basket", 4, boxes::basket),
    indoor("jewelry_box", 3, boxes::jewelry),
    indoor("ring", 2, jewelry::ring),
    indoor("necklace", 2, jewelry::necklace),
    indoor("earrings", 2, jewelry::earrings),
    indoor("bracelet", 2, jewelry::bracelet),
    indoor("watch", 4, jewelry::watch),
    indoor("smart_watch", 2, |b| settled(b, jewelry::watch)),
];
