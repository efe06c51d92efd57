function rgb = colour(hexadecimal)
% COLOUR  Converts '#RRGGBB' to red, green and blue from 0 to 1; a list of colours to one row for each.
digits = char(hexadecimal);
rgb = [hex2dec(digits(:, 2:3)), hex2dec(digits(:, 4:5)), hex2dec(digits(:, 6:7))] / 255;
end
