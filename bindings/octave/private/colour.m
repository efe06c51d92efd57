function rgb = colour(hexadecimal)
% COLOUR  Red, green and blue from 0 to 1 of '#RRGGBB', or a line of these for each of a list of colours.
digits = char(hexadecimal);
rgb = [hex2dec(digits(:, 2:3)), hex2dec(digits(:, 4:5)), hex2dec(digits(:, 6:7))] / 255;
end
