const get = id => document.getElementById(id);
const images = film.pictures.map(file => { const image = new Image(); image.src = file; return image; });
let at = 0, playing = true;
const actionAt = picture => film.starts.findLastIndex(start => start <= picture);
function show(picture) {
  at = picture;
  get("screen").src = images[at].src;
  get("seek").value = at;
  const action = actionAt(at);
  get("caption").textContent = film.captions[action] ?? "";
  document.querySelectorAll("#log tr").forEach(row => row.classList.toggle("now", row.dataset.action == action));
}
function play(on) {
  playing = on;
  get("play").textContent = on ? "pause" : "play";
}
get("play").onclick = () => play(!playing);
get("seek").oninput = () => { play(false); show(Number(get("seek").value)); };
document.querySelectorAll("#strip figure").forEach(figure => figure.onclick = () => show(Number(figure.dataset.at)));
document.addEventListener("click", event => {
  const row = event.target.closest("#log tr[data-action]");
  if (row) { show(Math.min(film.starts[row.dataset.action] ?? 0, images.length - 1)); get("film").scrollIntoView(); }
});
setInterval(() => { if (playing) show((at + 1) % images.length); }, 1000 / film.rate);
show(0);
