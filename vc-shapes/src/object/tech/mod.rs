//! Electronics: computers, screens, sound, cameras, phones and games.

mod audio;
mod camera;
mod computer;
mod desk;
mod gaming;
mod music;
mod phone;
mod printer;
mod rack;
mod screen;

use super::{Generator, indoor};
use crate::material::*;
use crate::solid::{Build, P};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("television", 10, screen::screen),
    indoor("monitor", 8, screen::screen),
    indoor("projector", 2, screen::projector),
    indoor("projector_screen", 2, screen::projector_screen),
    indoor("laptop", 6, computer::laptop),
    indoor("computer", 4, computer::tower),
    indoor("gaming_computer", 3, computer::tower),
    indoor("server", 2, computer::tower),
    indoor("tablet", 3, phone::slab),
    indoor("cellphone", 4, phone::slab),
    indoor("e_reader", 2, phone::slab),
    indoor("mp3_player", 2, phone::slab),
    indoor("keyboard", 4, desk::keyboard),
    indoor("mouse", 5, desk::mouse),
    indoor("graphic_tablet", 2, desk::graphic_tablet),
    indoor("webcam", 3, camera::webcam),
    indoor("docking_station", 2, rack::small),
    indoor("external_hard_drive", 2, rack::small),
    indoor("usb_stick", 2, desk::usb_stick),
    indoor("router", 3, rack::router),
    indoor("network_switch", 2, rack::small),
    indoor("power_bank", 2, rack::small),
    indoor("charger", 2, desk::charger),
    indoor("cable", 2, desk::cable),
    indoor("dvd_player", 2, rack::rack),
    indoor("set_top_box", 2, rack::rack),
    indoor("audio_amplifier", 3, rack::rack),
    indoor("stereo", 2, rack::rack),
    indoor("console", 3, rack::rack),
    indoor("printer", 2, printer::printer),
    indoor("laser_printer", 2, printer::printer),
    indoor("multifunction_printer", 2, printer::printer),
    indoor("photo_printer", 2, printer::printer),
    indoor("label_printer", 1, printer::label_printer),
    indoor("three_d_printer", 2, printer::three_d_printer),
    indoor("scanner", 2, printer::scanner),
    indoor("speaker", 5, audio::speaker),
    indoor("floor_speaker", 3, audio::speaker),
    indoor("subwoofer", 2, audio::speaker),
    indoor("soundbar", 2, audio::soundbar),
    indoor("bluetooth_speaker", 3, audio::portable),
    indoor("smart_speaker", 3, audio::portable),
    indoor("guitar_amplifier", 2, audio::guitar_amplifier),
    indoor("headset", 4, audio::headset),
    indoor("earphone", 2, audio::earphone),
    indoor("microphone", 3, audio::microphone),
    indoor("radio", 3, music::radio),
    indoor("cd_player", 2, music::radio),
    indoor("turntable", 3, music::turntable),
    indoor("mixing_console", 2, music::mixer),
    indoor("vinyl_record", 3, music::sleeve),
    indoor("dvd", 2, music::sleeve),
    indoor("video_game", 2, music::sleeve),
    indoor("cd", 2, music::disc),
    indoor("camera", 3, camera::camera),
    indoor("dslr_camera", 3, camera::camera),
    indoor("instant_camera", 2, camera::camera),
    indoor("action_camera", 2, camera::camera),
    indoor("video_camera", 2, camera::video_camera),
    indoor("security_camera", 2, camera::security),
    indoor("baby_monitor", 2, phone::handset),
    indoor("tripod", 2, camera::tripod),
    indoor("softbox", 2, camera::softbox),
    indoor("drone", 3, camera::drone),
    indoor("phone", 4, phone::desk_phone),
    indoor("wall_phone", 2, phone::wall_phone),
    indoor("walkie_talkie", 2, phone::handset),
    indoor("remote_control", 6, phone::remote),
    indoor("controller", 2, gaming::controller),
    indoor("video_game_controller", 3, gaming::controller),
    indoor("handheld_console", 2, gaming::handheld),
    indoor("joystick", 4, gaming::joystick),
    indoor("racing_wheel", 2, gaming::racing_wheel),
    indoor("virtual_headset", 3, gaming::virtual_headset),
];

/// A case of dark or light plastic.
fn case(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, SILVER_METAL])
}

/// A lens facing along an axis: a stepped barrel with glass in it.
fn lens(b: &mut Build<'_>, from: P, to: P, r: f32, barrel: MaterialId) {
    let long = nalgebra::distance(&nalgebra::Point3::from(from), &nalgebra::Point3::from(to));
    let steps = [
        (r, 0.0),
        (r, long * 0.4),
        (r * 0.9, long * 0.45),
        (r * 0.9, long * 0.98),
        (r * 0.85, long),
        (r * 0.7, long),
        (r * 0.55, long * 0.7),
    ];
    b.lathe_along("barrel", from, to, &steps, barrel);
    b.lathe_along("lens", from, to, &[(r * 0.6, long * 0.6), (r * 0.5, long * 0.86), (0.0, long * 0.92)], BLACK_GLASS);
}

/// A grid of keys on a level or upright rectangle: the corners of each, from `low`, stepping along
/// two axes.
fn grid(count: (usize, usize), key: impl Fn(f32, f32) -> (P, P)) -> Vec<(P, P)> {
    let (rows, columns) = count;
    (0..rows * columns).map(|k| key((k / columns) as f32, (k % columns) as f32)).collect()
}
