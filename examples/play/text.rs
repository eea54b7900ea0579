//! Text in a picture.

use font8x8::{BASIC_FONTS, UnicodeFonts};
use virtualcity::render::picture::Picture;

/// Height and width of a letter, pixels.
const LETTER: usize = 8;

/// A dark picture with one line of text in its middle, to be shown while there is no other.
pub(crate) fn notice(width: u32, height: u32, words: &str) -> Picture {
    let (width, height) = (width as usize, height as usize);
    let mut picture = Picture::new(width, height, [30, 34, 40]);
    write(&mut picture, (width / 2, height / 2), words);
    picture
}

/// Writes a centred line, white with a dark edge; text that does not fit is cut off.
pub(crate) fn write(picture: &mut Picture, (middle, top): (usize, usize), words: &str) {
    let most = picture.width / LETTER;
    let shown: Vec<char> = words.chars().take(most).collect();
    let left = middle.saturating_sub(shown.len() * LETTER / 2);
    for (shift, colour) in [((1, 1), [20, 20, 20]), ((0, 0), [250, 250, 250])] {
        for (index, letter) in shown.iter().enumerate() {
            draw(picture, (left + index * LETTER + shift.0, top + shift.1), *letter, colour);
        }
    }
}

fn draw(picture: &mut Picture, (left, top): (usize, usize), letter: char, colour: [u8; 3]) {
    let Some(rows) = BASIC_FONTS.get(letter) else { return };
    for (y, row) in rows.into_iter().enumerate() {
        for x in (0..LETTER).filter(|x| row >> x & 1 == 1) {
            if left + x < picture.width && top + y < picture.height {
                picture.pixels[(top + y) * picture.width + left + x] = colour;
            }
        }
    }
}

/// A cross in the middle.
pub(crate) fn crosshair(picture: &mut Picture) {
    let (x, y) = (picture.width / 2, picture.height / 2);
    for (dx, dy) in (2..6).flat_map(|d| [(d, 0), (-d, 0), (0, d), (0, -d)]) {
        let (Some(x), Some(y)) = (x.checked_add_signed(dx), y.checked_add_signed(dy)) else { continue };
        if let Some(pixel) = picture.pixels.get_mut(y * picture.width + x) {
            *pixel = pixel.map(|c| if c > 127 { 0 } else { 255 });
        }
    }
}
