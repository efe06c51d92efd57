function text = quoted(word)
% QUOTED  A word as the shell takes it, whatever is in it.
text = ['''' strrep(word, '''', '''\''''') ''''];
end
