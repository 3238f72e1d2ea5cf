// Elements, made of text that is never read as markup.

/** An HTML element with attributes and children. */
function html(tag, attributes = {}, ...children) {
  return furnish(document.createElement(tag), attributes, children);
}

/** An SVG element with attributes and children. */
function svg(tag, attributes = {}, ...children) {
  return furnish(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function furnish(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

function byId(id) {
  return document.getElementById(id);
}

/** A time that takes the cursor there when it is pressed. */
function moment(view, time, text = seconds(time)) {
  const button = html("button", { type: "button", class: "moment", title: "Move the cursor there" }, text);
  button.addEventListener("click", () => view.show(time));
  return button;
}
