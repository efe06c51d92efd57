function text = plain_text(text)
% PLAIN_TEXT  A text in which no letter means an index or an accent to TeX.
text = strrep(text, '_', '\_');
end
