function text = quoted(word)
% QUOTED  Quotes a word for the shell.
text = ['''' strrep(word, '''', '''\''''') ''''];
end
