var nt,yd,Wc,Ii,Vc,qo,xd,Wo,bd,Xc,Hc,Zg,Cr=Symbol.for("pv"),Yo={},Zo=[],$g=/^m(i|n|o|s|text|space)$/,qc=Array.isArray,Yc=Zo.slice,as=Object.assign;function os(n){n&&n.parentNode&&n.remove()}function Sd(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Yc.call(arguments,2):t),Rr(n,o,i,s,null)}function Rr(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Cr,__v:s||++yd,__i:-1,__u:0};return!s&&nt.vnode&&nt.vnode(r),r}function kt(n){return n.children}function Li(n,e){this.props=n,this.context=e,this.__g=0}function Di(n,e){if(e==null)return n.__&&Di(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Di(n)}function jg(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=as({constructor:Cr},t)).__v=t.__v+1,nt.vnode&&nt.vnode(e),Zc(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Di(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Rd(s,e,r),t.__=t.__e=null,e.__e!=i&&Md(e))}function Md(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Md(n)}function _d(n){(8&n.__g||(n.__g|=8,Ii.push(n),qo++))&&Vc==nt.debounceRendering||((Vc=nt.debounceRendering)||queueMicrotask)(wd)}function wd(){try{for(var n,e=1;Ii.length;)Ii.length>e&&Ii.sort(xd),n=Ii.shift(),e=Ii.length,8&n.__g&&jg(n)}finally{(qo=Ii.length)&&(Vc||queueMicrotask)(wd)}}function Td(n,e,t,i,s,r,o,a,c,l,h){var f,d,u,_,b,m,g=i.__k||Zo,S=e.length;for(c=Jg(t,e,g,c,S),f=0;f<S;f++)(u=t.__k[f])!=null&&(d=~u.__i&&g[u.__i]||Yo,u.__i=f,m=Zc(n,u,d,s,r,o,a,c,l,h),_=u.__e,(d.ref!=u.ref||8&d.__u)&&(d.ref&&$c(d.ref,null,u,d),u.ref&&h.push(u.ref,u.__c||_,u)),b=b||_,4&u.__u?(c=Ed(u,c,n,!d.__v),d.__e&&(d.__e=null)):typeof u.type=="function"&&m!==void 0?c=m:_&&(c=_.nextSibling),u.__u&=-21);return t.__e=b,c}function Jg(n,e,t,i,s){var r,o,a,c,l,h,f,d,u,_=t.length,b=_,m=0,g=0,S=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=S[r]=Rr(null,o):qc(o)?o=S[r]=Rr(kt,{children:o}):o.constructor===Cr&&o.__b?o=S[r]=Rr(o.type,o.props,o.key,o.ref,o.__v):S[r]=o,c=r+m,o.__=n,o.__b=n.__b+1,a=null,~(l=o.__i=Kg(o,t,c,b))&&(b--,(a=t[l])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,l==c-1?m--:l==c+1?m++:l!=c&&(l>c?m--:m++,g=1)):(~l||(s>_?m--:s<_&&m++),typeof o.type!="function"&&(o.__u|=4))):S[r]=null;if(g){for(h=[],f=[],r=0;r<s;r++)if((o=S[r])&&16&o.__u){for(m=0,d=h.length;m<d;)h[u=m+d>>1]<o.__i?m=u+1:d=u;h[m]=o.__i,f[r]=m+1}for(m=h.length;r--;)f[r]&&(f[r]==m?m--:S[r].__u|=4)}if(b)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Di(a)),jc(a,a));return i}function Ed(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Ed(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Di(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Kg(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],c=a&&!(2&a.__u);if(a===null&&r==null||c&&r==a.key&&o==a.type)return t;if(i>(c?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function vd(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ho(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||vd(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||vd(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Hc[e]||(Hc[e]=Qg(e)),(n.__a||(n.__a={}))[e]=Xc,r=e!=(e=e.replace(bd,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Qg(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Wo]==null)e[Wo]=Xc++;else if(e[Wo]<this.__a[n])return;return t(nt.event?nt.event(e):e)}}}function Zc(n,e,t,i,s,r,o,a,c,l){var h,f,d,u,_,b,m,g,S,E,M,C,R,v,w,B,N,O,G=e.type;if(e.constructor!==Cr)return null;128&t.__u&&(c=32&t.__u,h=t.__c.__z)&&(e.__u|=c,f=r=[],h.nodeType==8?a=Xo(h,r):r.push(h),a=r[0]||a),(h=nt.__b)&&h(e);e:if(typeof G=="function"){d=o.length;try{if(g=e.props,S=(h=G.prototype)&&h.render,E=(h=G.contextType)&&i[h.__c],M=h?E?E.props.value:h.__:i,(u=t.__c)?(e.__c=u,2&u.__g&&(u.__g|=1)):(S?e.__c=u=new G(g,M):(e.__c=u=new Li(g,M),u.constructor=G,u.render=t_),E&&E.sub(u),u.state||(u.state={}),u.__n=i,u.__g|=8,u.__h=[],u.__k=[]),S&&(u.__s||(u.__s=u.state),G.getDerivedStateFromProps&&(u.__s==u.state&&(u.__s=as({},u.__s)),as(u.__s,G.getDerivedStateFromProps(g,u.__s)))),_=u.props,b=u.state,u.__v=e,t.__c){if(g!==_&&S&&!G.getDerivedStateFromProps&&u.componentWillReceiveProps&&u.componentWillReceiveProps(g,M),e.__v==t.__v&&!(8&u.__g)||!(4&u.__g)&&u.shouldComponentUpdate&&u.shouldComponentUpdate(g,u.__s,M)===!1){e.__v!=t.__v&&(u.props=g,u.state=u.__s,u.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(W){W&&(W.__=e)}),Zo.push.apply(u.__h,u.__k),u.__k=[],u.__h.length&&o.push(u),a=Di(t);break e}u.componentWillUpdate&&u.componentWillUpdate(g,u.__s,M),S&&u.componentDidUpdate&&u.__h.push(function(){u.componentDidUpdate(_,b,m)})}else S&&!G.getDerivedStateFromProps&&u.componentWillMount&&u.componentWillMount(),S&&u.componentDidMount&&u.__h.push(u.componentDidMount);u.context=M,u.props=g,u.__P=n,u.__g&=-5,C=nt.__r,R=S?25:0;do u.__g&=-9,C&&C(e),h=u.render(u.props,u.state=u.__s,u.context);while(8&u.__g&&++R<25);S&&(Zo.push.apply(u.__h,u.__k),u.__k=[]),u.state=u.__s,u.getChildContext&&(i=as({},i,u.getChildContext())),S&&t.__c&&u.getSnapshotBeforeUpdate&&(m=u.getSnapshotBeforeUpdate(_,b)),v=h&&h.type===kt&&h.key==null?h.props.children:h,g.__P&&(h=a,s=(n=g.__P).namespaceURI,c=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(W){W&&jc(W,W)}),t.__k=null),a=t.__k?Di(t,0):null),a=Td(n,qc(v)?v:[v],e,t,i,s,r,o,a,c,l),g.__P&&(e.__e=null,a=h),e.__u&=-161,f&&f.some(os),u.__h.length&&o.push(u),1&u.__g&&(u.__g&=-4)}catch(W){if(o.length=d,e.__v=null,c||r)if(W&&W.then){if(e.__u|=128|c,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(O=r[N-1])&&O.nodeType==8;)N--;for(;N<r.length;N++)if(O=r[N])if(r[N]=null,w){if(O==B)break}else{if(O.nodeType!=8)break;O.data.startsWith("$s")&&(B=Xo(w=O))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(h=Xo(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=h):e.__e=a,a=a&&a.nextSibling}else r&&r.some(os);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),W&&W.then||Ad(e),nt.__e(W,e,t)}}else a=e.__e=e_(t.__e,e,t,i,s,r,o,c,l,n);return(h=nt.diffed)&&h(e),a}function Xo(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Ad(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Ad))}function Rd(n,e,t){for(var i=0;i<t.length;)$c(t[i++],t[i++],t[i++]);nt.__c&&nt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){nt.__e(r,s.__v)}})}function e_(n,e,t,i,s,r,o,a,c,l){var h,f,d,u,_,b,m,g,S=t.props||Yo,E=e.props,M=e.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(h=0;h<r.length;h++)if((_=r[h])&&(M?_.localName==M:_.nodeType==3)){n=_,r[h]=null;break}}if(!n){if(g=l.ownerDocument||document,!M)return g.createTextNode(E);n=g.createElementNS(s,M,E.is?E:l),a&&(nt.__m&&nt.__m(e,r),a=!1),r=null}if(M){if(l=M=="template"&&n.content||n,r=M=="textarea"&&E.defaultValue!=null?null:r&&Yc.call(l.childNodes),!a&&r)for(S={},h=0;h<n.attributes.length;h++)S[(_=n.attributes[h]).name]=_.value;for(h in S)_=S[h],h=="dangerouslySetInnerHTML"?d=_:h=="children"||h in E||h=="value"&&"defaultValue"in E||h=="checked"&&"defaultChecked"in E||Ho(n,h,null,_,s);for(h in E)_=E[h],h=="children"?u=_:h=="dangerouslySetInnerHTML"?f=_:h=="value"?b=_:h=="checked"?m=_:a&&typeof _!="function"||S[h]===_||Ho(n,h,_,S[h],s);f?(a||d&&(f.__html==d.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(d&&(n.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&$g.test(M))&&(s="http://www.w3.org/1999/xhtml"),Td(l,qc(u)?u:[u],e,t,i,s,r,o,r?r[0]:t.__k&&Di(t,0),a,c),r&&r.some(os)),a&&M!="textarea"||(h="value",M=="progress"&&b==null?n.removeAttribute(h):b==null||b===n[h]&&(M!="progress"||b)||Ho(n,h,b,S[h],s),h="checked",m!=null&&m!=n[h]&&Ho(n,h,m,S[h],s))}else S===E||a&&n.data==E||(n.data=E);return n}function $c(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){nt.__e(s,t)}}function jc(n,e,t){var i,s,r,o;if(nt.unmount&&nt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||$c(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){nt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&jc(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Xo(i,r=[]))&&(i==n.__e&&r.some(os),os(s),os(i)),t||os(n.__e),n.__e=n.__c=n.__=null}function t_(n,e,t){return this.constructor(n,t)}function Cd(n,e){var t,i,s,r;nt.__&&nt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Rr(kt,{children:[n]}),s=[],r=[],Zc(e,e.__k,i||Yo,Yo,e.namespaceURI,i?null:e.firstChild?Yc.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Rd(s,e.__k,r),e.__k.props.children=null}nt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw qo=0,n}},yd=0,Wc=function(n){return n!=null&&n.constructor===Cr},Li.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=as({},this.state)),typeof n=="function"&&(n=n(as({},t),this.props)),n&&(as(t,n),this.__v&&(e&&this.__k.push(e),_d(this)))},Li.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),_d(this))},Li.prototype.render=kt,Ii=[],qo=0,xd=function(n,e){return n.__v.__b-e.__v.__b},Wo=Symbol(),bd=/(PointerCapture)$|Capture$/i,Xc=0,Hc={},Zg=0;var ls,At,Jc,Pd,Kc=Object.is,$o=0,kd=[],Qc=[],Et=nt,Id=Et.__b,Ld=Et.__r,Dd=Et.diffed,Nd=Et.__c,Ud=Et.unmount,Od=Et.__;function Ir(n,e){Et.__h&&Et.__h(At,n,$o||e),$o=0;var t=At.__H||(At.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Xe(n){return $o=1,n_(Gd,n)}function n_(n,e,t){var i=Ir(ls++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Gd(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Kc(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=At,!At.__f)){At.__f=!0;var s=At.shouldComponentUpdate;At.shouldComponentUpdate=function(r,o,a){var c=this.__H;if(!c)return!0;var l=!1,h=this.props!=r;if(c.__.some(function(d){d.__N&&(l=!0,Kc(d.__[0],d.__N[0])||(h=!0))}),s){var f=s.call(this,r,o,a);return l?f||h:f}return!l||h}}return i.__}function gt(n,e){var t=Ir(ls++,3);!Et.__s&&th(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,At.__H.__h.push(t))}function Ns(n,e){var t=Ir(ls++,4);!Et.__s&&th(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,At.__h.push(t))}function Lt(n){return $o=5,jo(function(){return{current:n}},[])}function jo(n,e){var t=Ir(ls++,7);return th(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function zd(){var n=Ir(ls++,11);if(!n.__){for(var e=At.__v;!e.__m&&e.__;)e=e.__;var t=e.__m||(e.__m=[0,0]);n.__="P"+t[0]+"-"+t[1]++}return n.__}function i_(){var n;do{for(;n=Qc.shift();)try{Pr(n)}catch(t){Et.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=kd.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Pr),e.__h.some(eh),e.__h=[]}catch(t){e.__h=[],Et.__e(t,n.__v)}}}while(Qc.length)}Et.__b=function(n){At=null,Id&&Id(n)},Et.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Od&&Od(n,e)},Et.__r=function(n){Ld&&Ld(n),ls=0;var e=(At=n.__c).__H;e&&(Jc==At?At.__h=[]:(e.__h.some(Pr),e.__h.some(eh),ls=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Jc=At},Et.diffed=function(n){Dd&&Dd(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Bd(kd.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Jc=At=null},Et.__c=function(n,e){e.some(function(t){try{t.__h.some(Pr),t.__h=t.__h.filter(function(i){return!i.__||eh(i)})}catch(i){t.__h=[function(){throw i}]}}),Nd&&Nd(n,e)},Et.unmount=function(n){Ud&&Ud(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Bd(Qc.push(s))}else Pr(s)}catch(r){e=r}}),i.__H=void 0,e&&Et.__e(e,i.__v))};var Fd=typeof requestAnimationFrame=="function";function s_(n){var e,t=function(){clearTimeout(i),Fd&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Fd&&(e=requestAnimationFrame(t))}function Bd(n){n!=1&&Pd==Et.requestAnimationFrame||((Pd=Et.requestAnimationFrame)||s_)(i_)}function Pr(n){var e=At,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),At=e}function eh(n){var e=At;n.__c=n.__(),At=e}function th(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Kc(t,n[i])})}function Gd(n,e){return typeof e=="function"?e(n):e}var r_=Symbol.for("preact-signals");function ea(){if(hi>1)hi--;else{var n,e=!1;for((function(){var s=Ko;for(Ko=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();Dr!==void 0;){var t=Dr;for(Dr=void 0,Jo++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Hd(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Jo=0,hi--,e)throw n}}function ih(n){if(hi>0)return n();nh=++o_,hi++;try{return n()}finally{ea()}}var Lr,xt=void 0;function cs(n){var e=xt,t=Lr;xt=void 0,Lr=void 0;try{return n()}finally{xt=e,Lr=t}}var Dr=void 0,hi=0,Jo=0,o_=0,nh=0,Ko=void 0,Qo=0;function Vd(n){if(xt!==void 0){var e=n.n;if(e===void 0||e.t!==xt)return e={i:0,S:n,p:xt.s,n:void 0,t:xt,e:void 0,x:void 0,r:e},xt.s!==void 0&&(xt.s.n=e),xt.s=e,n.n=e,32&xt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=xt.s,e.n=void 0,xt.s.n=e,xt.s=e),e}}function zt(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}zt.prototype.brand=r_;zt.prototype.h=function(){return!0};zt.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:cs(function(){var i;(i=e.W)==null||i.call(e)}))};zt.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&cs(function(){var s;(s=e.Z)==null||s.call(e)}))}};zt.prototype.subscribe=function(n){var e=this;return Ze(function(){var t=e.value;cs(function(){return n(t)})},{name:"sub"})};zt.prototype.valueOf=function(){return this.value};zt.prototype.toString=function(){return this.value+""};zt.prototype.toJSON=function(){return this.value};zt.prototype.peek=function(){var n=this;return cs(function(){return n.value})};Object.defineProperty(zt.prototype,"value",{get:function(){var n=Vd(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Jo>100)throw new Error("Cycle detected");(function(t){hi!==0&&Jo===0&&t.l!==nh&&(t.l=nh,Ko={S:t,v:t.v,i:t.i,o:Ko})})(this),this.v=n,this.i++,Qo++,hi++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{ea()}}}});function we(n,e){return new zt(n,e)}function Hd(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function Wd(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function Xd(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function hs(n,e){zt.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Qo-1,this.f=4}hs.prototype=new zt;hs.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Qo))return!0;if(this.g=Qo,this.f|=1,this.i>0&&!Hd(this))return this.f&=-2,!0;var n=xt;try{Wd(this),xt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return xt=n,Xd(this),this.f&=-2,!0};hs.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}zt.prototype.S.call(this,n)};hs.prototype.U=function(n){if(this.t!==void 0&&(zt.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};hs.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(hs.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=Vd(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function bn(n,e){return new hs(n,e)}function qd(n){var e=n.j;if(n.j=void 0,typeof e=="function"){hi++;var t=xt;xt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,sh(n),i}finally{xt=t,ea()}}}function sh(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,qd(n)}function a_(n){if(xt!==this)throw new Error("Out-of-order effect");Xd(this),xt=n,this.f&=-2;try{8&this.f&&sh(this)}finally{ea()}}function Us(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Lr&&Lr.push(this)}Us.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Us.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,qd(this),Wd(this),hi++;var n=xt;return xt=this,a_.bind(this,n)};Us.prototype.N=function(){2&this.f||(this.f|=2,this.u=Dr,Dr=this)};Us.prototype.d=function(){this.f|=8,1&this.f||sh(this)};Us.prototype.dispose=function(){this.d()};function Ze(n,e){var t=new Us(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var Yd,na,ta,l_=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__;var Zd=[];Ze(function(){Yd=this.N})();function Os(n,e){nt[n]=e.bind(null,nt[n]||function(){})}function Nr(n){if(ta){var e=ta;ta=void 0,e()}ta=n&&n.S()}function $d(n){var e=this,t=n.data,i=h_(t);i.name="ReactiveDom",i.value=t;var s=jo(function(){for(var a=e,c=e.__v;c=c.__;)if(c.__c){c.__c.__$f|=4;break}var l=bn(function(){var u=i.value.value;return u===0?0:u===!0?"":u||""}),h=bn(function(){return!Array.isArray(l.value)&&!Wc(l.value)}),f=Ze(function(){if(this.N=jd,h.value){var u=l.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=u)}}),d=e.__$u.d;return e.__$u.d=function(){f(),d.call(this)},[h,l]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}$d.displayName="ReactiveTextNode";Object.defineProperties(zt.prototype,{constructor:{configurable:!0,value:Sd(kt,null).constructor},type:{configurable:!0,value:$d},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Os("__b",function(n,e){if(Nr(),na=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof zt&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});Os("__r",function(n,e){if(n(e),e.type!==kt){Nr();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return Ze(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;l_&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),na=i,Nr(t)}});Os("__e",function(n,e,t,i){Nr(),na=void 0,n(e,t,i)});Os("diffed",function(n,e){Nr(),na=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var c in i){var l=r[c],h=i[c];l===void 0?(l=c_(t,c,h,s),r[c]=l):l.o(h,s)}}}n(e)});function c_(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=we(t);return{o:function(o,a){r.value=o,i=a},d:Ze(function(){this.N=jd;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}Os("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var c in o)a[c]=o[c]}e.__np=void 0}else{var l=e.__c;if(l){l.__$f|=8;var h=l.__$u;h&&(l.__$u=void 0,h.d())}}n(e)});Os("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Li.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function h_(n,e){return jo(function(){return we(n,e)},[])}var u_=function(n){queueMicrotask(function(){queueMicrotask(n)})};function d_(){ih(function(){for(var n;n=Zd.shift();)Yd.call(n)})}function jd(){Zd.push(this)===1&&(nt.requestAnimationFrame||u_)(d_)}var Jd={"app.name":"Sitewright","nav.cell":"Zelle","nav.building":"Bauwerk","nav.runs":"Läufe","nav.audit":"Nachweis","nav.health":"Zustand","nav.label":"Ansichten",language:"Sprache",safety:"Diese Seite ist keine Sicherheitseinrichtung.","link.connecting":"Verbinde","link.live":"Live","link.stale":"Altes Bild: {seconds} s","link.absent":"Keine Zelle","link.lost":"Keine Verbindung","lost.title":"Keine Verbindung.","lost.text":"Diese Seite kann die Roboter jetzt weder zeigen noch anhalten. Benutzen Sie den Halt an der Zelle.","lost.note":"Notiz für Sie selbst (bleibt nur auf dieser Seite)","signed-out.title":"Diese Seite ist nicht angemeldet","signed-out.text":"Öffnen Sie den Link, den sitewright serve ausgegeben hat. Er gilt einmal; ein neuer Start gibt einen neuen.",broken:"Der Lauf ist durch einen Fehler stehen geblieben.","phase.idle":"Nichts läuft","phase.planning":"Plant","phase.waiting":"Wartet auf Sie","phase.running":"Läuft","phase.holding":"Hält an","phase.held":"Angehalten","phase.question":"Eine Frage an Sie","phase.needs-help":"Braucht Hilfe","phase.finished":"Fertig","phase.broken":"Durch Fehler beendet",progress:"{installed} von {targets} eingebaut","act.hold":"Anhalten","act.hold.note":"eine Bitte; der Halt ist an der Zelle","act.hold.sent":"Die Zelle wurde um Halt gebeten","act.hold.failed":"Die Bitte kam nicht an. Benutzen Sie den Halt an der Zelle.","act.resume":"Weiter","act.start":"Beginnen","act.reject":"Ablehnen","act.other":"Anders","act.step":"Schritt für Schritt","act.step.note":"nur Schritt {number}","act.until":"Bis {number} freigeben","act.until.none":"Bis … freigeben","act.all":"Alles freigeben","act.all.note.one":"{count} Schritt","act.all.note.other":"{count} Schritte","act.show":"Zum Plan","act.cancel":"Abbrechen","act.close":"Schließen","act.send":"Senden","act.choose":"Wählen","act.again":"Noch einmal fragen","acts.label":"Entscheidungen über Plan {code}","wait.changed":"Eben geändert","wait.differences":"Änderungen ansehen","wait.flagged":"Erst Schritt {number} ansehen","wait.busy":"Wird festgehalten","wait.until":"Schritt wählen","role.lacks":"Ihre Rolle ({role}) darf das nicht","done.approved":"Festgehalten: freigegeben von {who}","done.rejected":"Festgehalten: abgelehnt von {who}","done.other":"Festgehalten: {who}","done.unknown":"Es kam keine Antwort. Noch weiß niemand, ob es festgehalten wurde.","stale.title":"Der Plan hat sich geändert","stale.open":"Nichts wurde freigegeben. Der offene Plan ist {code}.","stale.none":"Nichts wurde freigegeben. Es ist kein Plan offen.","plan.title":"Plan","plan.code":"Prüfcode","plan.duration":"Dauer","plan.closest":"Kleinster Abstand","plan.short":"In Kürze","plan.steps.one":"{count} Schritt","plan.steps.other":"{count} Schritte","plan.list":"Schritte des Plans","plan.changed":"Geändert seit {code}","plan.changed.none":"Was sich geändert hat","plan.notes":"Auf dem Weg zu diesem Plan verworfen","plan.single":"Ein gewählter Schritt","plan.none.idle":"Kein Plan ist offen. Mit „Beginnen“ wird einer gemacht.","plan.none.planning":"Es wird geplant. Kein Roboter bewegt sich, bevor Sie freigeben.","plan.none.running":"Die freigegebenen Schritte laufen.","plan.none.held":"Angehalten. Nichts beginnt, bevor jemand weitermacht.","plan.none.finished":"Alles, was gebaut werden konnte, ist gebaut.","plan.none.other":"Kein Plan ist offen.","plan.robots":"Roboter","step.play":"Schritt zeigen","step.why":"Warum?","step.motion":"Andere Bewegung","step.done":"erledigt","step.running":"läuft","step.not done":"nicht erledigt","step.superseded":"überholt","step.look":"Diesen Schritt ansehen","step.seen":"angesehen","step.closest":"{distance} mm zwischen {first} und {second}","step.distance":"{distance} mm","step.still":"kein Gelenk bewegt sich","step.robot":"Roboter {number}","mode.label":"Was gezeigt wird","mode.now":"Jetzt","mode.preview":"Vorschau","mode.target":"Ziel","mode.as-built":"Gebaut","view.label":"Blick von","view.whole":"Ganz","view.top":"Oben","view.front":"Vorn","view.side":"Seite","view.robot":"Roboter {number}","view.follow":"Folgen {number}","picture.label":"3D-Bild der Zelle. Schritte und Bauteile stehen in den Listen daneben.","picture.failed":"Dieser Browser kann das 3D-Bild nicht zeichnen: {reason}","picture.stale":"Roboter grau: das letzte Bild der Sensoren ist {seconds} s alt.","picture.refused":"So wurde es versucht, nicht die Zelle jetzt: die zwei in Rot kommen sich zu nahe.","picture.blockers":"Was im Weg ist, in Rot.","picture.back":"Zurück zur Zelle","picture.preview":"Vorschau: nicht die Zelle","preview.play":"Abspielen","preview.pause":"Pause","preview.back":"Schritt zurück","preview.next":"Schritt weiter","preview.start":"Zum Anfang","preview.time":"Zeit im Plan","preview.none":"Es gibt keinen Plan für eine Vorschau.","preview.loading":"Die Bahnen werden geladen.","preview.failed":"Die Vorschau wird verweigert: {reason}","gantt.label":"Zeitplan: geplant (Umriss) und wirklich (voll)","tree.title":"Bauteile","tree.list":"Bauteile nach Ebenen","tree.show":"{name} zeigen","tree.lock":"{name} sperren: Tippen ins Bild geht hindurch","tree.search":"Bauteil suchen","layer.target":"Zu bauen","layer.material":"Vorrat","layer.as_built":"Gebaut","layer.as_designed":"Nur gezeichnet","layer.virtual_collision":"Freihalten","state.waiting":"wartet auf andere","state.ready":"bereit","state.active":"in diesem Plan","state.in-place":"am Platz, noch gehalten","state.standing":"steht von selbst","state.installed":"eingebaut","state.refused":"abgewiesen","state.needs-rework":"muss nachgearbeitet werden","state.stock":"im Vorrat","state.held":"im Greifer","state.used":"in Arbeit","state.stray":"liegt, wo es niemand erwartet","state.gone":"wird nicht mehr gesehen","card.label":"Gewähltes Bauteil","card.type":"Art","card.layer":"Ebene","card.state":"Stand","card.material":"Material","card.parents":"Ruht auf","card.waits":"Wartet auf","card.made":"Gemacht aus","card.place":"Liegt bei","card.operations":"Arbeiten","card.operations.done":"{done} von {count} erledigt","card.accessible":"greifbar","card.mismatch":"Stimmt nicht mit der Baustelle","card.close":"Karte schließen","reject.title":"Diesen Plan ablehnen","reject.why":"Warum?","reject.step":"Worum geht es?","reject.whole":"Um den ganzen Plan","reject.one":"Um Schritt {number}","reject.detail":"Wenn Sie mehr sagen möchten","reason.wrong-component":"Falsches Bauteil","reason.wrong-robot":"Falscher Roboter","reason.path-unsafe":"Der Weg sieht unsicher aus","reason.site-differs":"Auf der Baustelle ist es anders","reason.later":"Später","reason.other":"Etwas anderes","other.title":"Anders","other.feasible":"Was stattdessen als Nächstes ginge","other.note":"Ihre Wahl kommt als Plan mit einem Schritt und eigenem Weg zurück und wird noch einmal gefragt.","other.price":"{seconds} s","other.none":"Es geht jetzt nichts anderes.","other.infeasible":"Was nicht geht, und warum","other.loading":"Jede Möglichkeit wird geprüft …","other.zone":"Sperrzone zeichnen","other.motion":"Andere Bewegung für Schritt {number}","zone.title":"Sperrzone","zone.text":"Roboter und Teile bleiben aus diesem Quader. Der offene Plan gilt nicht mehr und wird neu gemacht.","zone.x":"Mitte x (m)","zone.y":"Mitte y (m)","zone.z":"Mitte z (m)","zone.length":"Länge (m)","zone.width":"Breite (m)","zone.height":"Höhe (m)","zone.tap":"Ein Tippen ins Bild setzt sie dorthin.","zone.save":"Sperren","mismatch.title":"{name} stimmt nicht mit der Baustelle","mismatch.text":"Der Lauf wird angehalten, der offene Plan gilt nicht mehr.","mismatch.detail":"Was ist anders?","help.title":"Braucht Hilfe","help.pair":"Im Weg: {first} und {second}","help.options":"Was möglich ist","help.show":"Zeigen","verdict.proven":"Es ist bewiesen, dass nichts in diesem Projekt es kann: kein Roboter, kein Griff, keine Reihenfolge. Modell oder Zelle müssen geändert werden.","verdict.blocked":"Etwas ist im Weg. Ohne das könnte sich ein Weg finden.","verdict.not-found":"Die Suche endete ohne Weg; es kann trotzdem einen geben.","verdict.person":"Bis dahin rührt der Lauf es nicht an.","verdict.rejected":"Ein Mensch hat abgelehnt, und ein anderer Plan wurde nicht gefunden. Derselbe Plan kann noch einmal vorgelegt werden; ohne Ja geschieht nichts.","verdict.wish":"Es kommt wieder, wenn alles andere getan ist, oder im nächsten Lauf.","help.tried":"An einer Kopie erprobt, und es geht:","help.tried-one":"{words} ({steps} Schritte, {seconds} s)","help.none":"Kein Ausweg ist bekannt. Ändern Sie Modell oder Zelle, dann weiter.","help.manual":"Von Hand erledigt","question.title":"Ist es geschehen?","answer.done":"Ja, es ist erledigt","answer.not-done":"Nein, es ist nicht erledigt","answer.partial":"Nur zum Teil","manual.title":"{name} wurde von Hand erledigt","manual.text":"Haken Sie ab, was jetzt wahr ist. Der Lauf glaubt Ihnen und prüft, was er messen kann.","building.order":"Reihenfolge","building.slider":"Zahl der Bauteile, die stehen","building.shown":"{count} von {total} stehen","building.graph":"Was worauf ruht","building.graph.label":"Graph der Baubeziehungen: Bauteil wählen","building.jobsite":"Baustelle","runs.title":"Läufe dieses Projekts","runs.none":"Es gibt noch keinen Lauf.","runs.open":"offen","runs.complete":"vollständig","runs.finished":"beendet","runs.held":"angehalten","runs.report":"Bericht","runs.installed":"{installed} von {targets} eingebaut","runs.events":"Was geschah","runs.choose":"Wählen Sie einen Lauf, um zu sehen, was geschah.","audit.title":"Wer entschied was, wann, worüber","audit.none":"Noch wurde nichts entschieden.","audit.when":"Wann","audit.who":"Wer","audit.what":"Was","audit.code":"Plan","audit.seen":"Gesehener Text","health.title":"Zustand","health.server":"Server","health.run":"Lauf","health.cell":"Zelle","health.journal":"Journal","health.disk":"Freier Plattenplatz","health.uptime":"läuft seit {seconds} s","health.clients.one":"{count} Seite offen","health.clients.other":"{count} Seiten offen","health.whole":"Hash-Kette ist heil","health.not-whole":"Hash-Kette ist gebrochen","health.alive":"lebt","health.dead":"nicht da","health.page":"Diese Seite","health.frame":"{ms} ms Skript je Bild, {calls} Zeichenaufrufe","journal.title":"Journal","journal.none":"Seit diese Seite offen ist, geschah nichts.","view.open":"Ansicht","done.second":"Vermerkt. Eine zweite Person muss dasselbe entscheiden.",fault:"Dieser Teil der Seite ist ausgefallen: {reason}. Die Roboter betrifft das nicht; Anhalten geht weiter.","fault.reload":"Seite neu laden","zone.remove":"Sperrzone aufheben","picture.replay":"Wiedergabe: nicht die Zelle von jetzt","verb.approve":"Freigegeben","verb.reject":"Abgelehnt","verb.instead":"Andere Handlung gewählt","verb.new-motion":"Andere Bewegung verlangt","verb.hold":"Angehalten","verb.resume":"Weitergemacht","verb.answer":"Geantwortet","verb.mismatch":"Abweichung der Baustelle gemeldet","verb.zone":"Sperrzonen geändert","verb.manual":"Von Hand erledigt","scope.plan":"den ganzen Plan","scope.until":"bis Schritt {step}","scope.step":"nur Schritt {step}","tree.zones":"Sperrzonen","sign-in.user":"Name","sign-in.token":"Token","sign-in.go":"Anmelden","sign-in.or":"Oder melden Sie sich mit Name und eigenem Token an:","pin.title":"Wer entscheidet?","pin.pin":"PIN",loading:"Lädt …",failed:"Das ging nicht: {reason}"};var Kd={"app.name":"Sitewright","nav.cell":"Cell","nav.building":"Building","nav.runs":"Runs","nav.audit":"Audit","nav.health":"Health","nav.label":"Screens",language:"Language",safety:"This page is not a safety device.","link.connecting":"Connecting","link.live":"Live","link.stale":"Old picture: {seconds} s","link.absent":"No cell","link.lost":"No connection","lost.title":"No connection.","lost.text":"This page cannot show or hold the robots now. Use the stop on the cell.","lost.note":"Note for yourself (kept on this page only)","signed-out.title":"This page is not signed in","signed-out.text":"Open the link that sitewright serve printed. It works once; restart the command for a new one.",broken:"The run has stopped with an error.","phase.idle":"Nothing is under way","phase.planning":"Making a plan","phase.waiting":"Waiting for you","phase.running":"Running","phase.holding":"Holding","phase.held":"Held","phase.question":"A question for you","phase.needs-help":"Needs help","phase.finished":"Finished","phase.broken":"Stopped by an error",progress:"{installed} of {targets} installed","act.hold":"Hold","act.hold.note":"a request; the stop is on the cell","act.hold.sent":"Hold was sent to the cell","act.hold.failed":"The hold did not reach the cell. Use the stop on the cell.","act.resume":"Go on","act.start":"Begin","act.reject":"Reject","act.other":"Other way","act.step":"Step by step","act.step.note":"step {number} only","act.until":"Approve until {number}","act.until.none":"Approve until …","act.all":"Approve all","act.all.note.one":"{count} step","act.all.note.other":"{count} steps","act.show":"Show the plan","act.cancel":"Cancel","act.close":"Close","act.send":"Send","act.choose":"Choose","act.again":"Ask again","acts.label":"Decisions about plan {code}","wait.changed":"Just changed","wait.differences":"See what changed","wait.flagged":"Look at step {number} first","wait.busy":"Being recorded","wait.until":"select a step","role.lacks":"Your role ({role}) may not do this","done.approved":"Recorded: approved by {who}","done.rejected":"Recorded: rejected by {who}","done.other":"Recorded: {who}","done.unknown":"No answer came. Nobody knows yet whether it was recorded.","stale.title":"The plan changed","stale.open":"Nothing was approved. The open plan is {code}.","stale.none":"Nothing was approved. No plan is open now.","plan.title":"Plan","plan.code":"Check code","plan.duration":"Time","plan.closest":"Closest","plan.short":"In short","plan.steps.one":"{count} step","plan.steps.other":"{count} steps","plan.list":"Steps of the plan","plan.changed":"What changed since {code}","plan.changed.none":"What changed","plan.notes":"Refused on the way to this plan","plan.single":"One chosen step","plan.none.idle":"No plan is open. Begin to let the planner make one.","plan.none.planning":"The planner is at work. No robot moves until you approve.","plan.none.running":"The approved steps are running.","plan.none.held":"Held. Nothing starts until somebody goes on.","plan.none.finished":"Everything that could be built is built.","plan.none.other":"No plan is open.","plan.robots":"Robots","step.play":"Show this step","step.why":"Why?","step.motion":"Other motion","step.done":"done","step.running":"running","step.not done":"not done","step.superseded":"superseded","step.look":"Look at this step","step.seen":"seen","step.closest":"{distance} mm between {first} and {second}","step.distance":"{distance} mm","step.still":"no joint moves","step.robot":"Robot {number}","mode.label":"What is shown","mode.now":"Now","mode.preview":"Preview","mode.target":"Target","mode.as-built":"As built","view.label":"Look from","view.whole":"All","view.top":"Top","view.front":"Front","view.side":"Side","view.robot":"Robot {number}","view.follow":"Follow {number}","picture.label":"3D picture of the cell. Steps and components are in the lists beside it.","picture.failed":"This browser cannot draw the 3D picture: {reason}","picture.stale":"Robots are grey: the last sensed picture is {seconds} s old.","picture.refused":"As it was tried, not the cell now: the two in red come too near.","picture.blockers":"What is in the way, in red.","picture.back":"Back to the cell","picture.preview":"Preview: not the cell","preview.play":"Play","preview.pause":"Pause","preview.back":"Step back","preview.next":"Step on","preview.start":"To the start","preview.time":"Time in the plan","preview.none":"There is no plan to preview.","preview.loading":"The trajectories are being loaded.","preview.failed":"The preview is refused: {reason}","gantt.label":"Schedule: planned (outline) and actual (solid)","tree.title":"Components","tree.list":"Components by layer","tree.show":"Show {name}","tree.lock":"Lock {name}: taps in the picture go through it","tree.search":"Find a component","layer.target":"To be built","layer.material":"Stock","layer.as_built":"Built","layer.as_designed":"Drawn only","layer.virtual_collision":"Keep clear","state.waiting":"waits for others","state.ready":"ready","state.active":"in this plan","state.in-place":"in place, still held","state.standing":"stands by itself","state.installed":"installed","state.refused":"refused","state.needs-rework":"needs rework","state.stock":"in stock","state.held":"in a gripper","state.used":"in use","state.stray":"lies where nobody expects it","state.gone":"not seen any more","card.label":"Selected component","card.type":"Type","card.layer":"Layer","card.state":"State","card.material":"Material","card.parents":"Rests on","card.waits":"Waits for","card.made":"Made of","card.place":"Lies at","card.operations":"Operations","card.operations.done":"{done} of {count} done","card.accessible":"accessible","card.mismatch":"Does not match the site","card.close":"Close the card","reject.title":"Reject this plan","reject.why":"Why?","reject.step":"What about?","reject.whole":"The whole plan","reject.one":"Step {number}","reject.detail":"Say more, if you like","reason.wrong-component":"Wrong component","reason.wrong-robot":"Wrong robot","reason.path-unsafe":"The path looks unsafe","reason.site-differs":"The site is different","reason.later":"Later","reason.other":"Something else","other.title":"Another way","other.feasible":"What could be done next instead","other.note":"Your choice comes back as a plan of one step, with its own path, and is asked again.","other.price":"{seconds} s","other.none":"Nothing else can be done now.","other.infeasible":"What cannot be done, and why","other.loading":"Each way is being checked …","other.zone":"Draw a keep-out zone","other.motion":"Other motion for step {number}","zone.title":"Keep-out zone","zone.text":"Robots and pieces stay out of this box. The open plan is void and made anew.","zone.x":"Middle x (m)","zone.y":"Middle y (m)","zone.z":"Middle z (m)","zone.length":"Length (m)","zone.width":"Width (m)","zone.height":"Height (m)","zone.tap":"Tap the picture to move it there.","zone.save":"Keep out","mismatch.title":"{name} does not match the site","mismatch.text":"The run is held, and the open plan is void.","mismatch.detail":"What is different?","help.title":"Needs help","help.pair":"In the way: {first} and {second}","help.options":"What can be done","help.show":"Show it","verdict.proven":"It is proven that nothing in this project can do it: no robot, no grasp, no order. Change the model or the cell.","verdict.blocked":"Something is in the way. Without it a way might be found.","verdict.not-found":"The search ended without a way; there may be one all the same.","verdict.person":"The run does not touch it until then.","verdict.rejected":"A person said no, and no other plan was found. The same plan can be asked for again; nothing is done without a yes.","verdict.wish":"It comes again when everything else is done, or in the next run.","help.tried":"Tried on a copy, and it works:","help.tried-one":"{words} ({steps} steps, {seconds} s)","help.none":"No way out is known. Change the model or the cell, then go on.","help.manual":"Done by hand","question.title":"Did it happen?","answer.done":"Yes, it is done","answer.not-done":"No, it is not done","answer.partial":"Only in part","manual.title":"{name} was done by hand","manual.text":"Tick what is true now. The run believes you, and looks at what it can sense.","building.order":"Building order","building.slider":"Number of components that stand","building.shown":"{count} of {total} stand","building.graph":"What rests on what","building.graph.label":"Construction relationship graph: select a component","building.jobsite":"Jobsite","runs.title":"Runs of this project","runs.none":"There is no run yet.","runs.open":"open","runs.complete":"complete","runs.finished":"finished","runs.held":"held","runs.report":"Report","runs.installed":"{installed} of {targets} installed","runs.events":"What happened","runs.choose":"Choose a run to see what happened.","audit.title":"Who decided what, when, on what","audit.none":"Nothing was decided yet.","audit.when":"When","audit.who":"Who","audit.what":"What","audit.code":"Plan","audit.seen":"Text that was seen","health.title":"Health","health.server":"Server","health.run":"Run","health.cell":"Cell","health.journal":"Journal","health.disk":"Free disk space","health.uptime":"up for {seconds} s","health.clients.one":"{count} page open","health.clients.other":"{count} pages open","health.whole":"chain of hashes is whole","health.not-whole":"chain of hashes is broken","health.alive":"alive","health.dead":"not there","health.page":"This page","health.frame":"{ms} ms script per picture, {calls} draw calls","journal.title":"Journal","journal.none":"Nothing has happened since this page was opened.","view.open":"View","done.second":"Noted. A second person must decide the same.",fault:"This part of the page has failed: {reason}. The robots are not affected; Hold still works.","fault.reload":"Load the page again","zone.remove":"Take the keep-out zone away","picture.replay":"Replay: not the cell now","verb.approve":"Approved","verb.reject":"Rejected","verb.instead":"Chose another action","verb.new-motion":"Asked for another motion","verb.hold":"Held","verb.resume":"Went on","verb.answer":"Answered","verb.mismatch":"Said that the site is different","verb.zone":"Changed keep-out zones","verb.manual":"Did it by hand","scope.plan":"the whole plan","scope.until":"until step {step}","scope.step":"step {step} only","tree.zones":"Keep-out zones","sign-in.user":"Name","sign-in.token":"Token","sign-in.go":"Sign in","sign-in.or":"Or sign in with a name and a token of your own:","pin.title":"Who decides?","pin.pin":"PIN",loading:"Loading …",failed:"That did not work: {reason}"};var Qd={"app.name":"Sitewright","nav.cell":"Celda","nav.building":"Obra","nav.runs":"Ejecuciones","nav.audit":"Registro","nav.health":"Estado","nav.label":"Pantallas",language:"Idioma",safety:"Esta página no es un dispositivo de seguridad.","link.connecting":"Conectando","link.live":"En vivo","link.stale":"Imagen antigua: {seconds} s","link.absent":"Sin celda","link.lost":"Sin conexión","lost.title":"Sin conexión.","lost.text":"Esta página no puede mostrar ni detener los robots ahora. Use la parada de la celda.","lost.note":"Nota para usted (queda solo en esta página)","signed-out.title":"Esta página no ha iniciado sesión","signed-out.text":"Abra el enlace que mostró sitewright serve. Sirve una vez; reinicie el comando para obtener otro.",broken:"La ejecución se detuvo por un error.","phase.idle":"Nada en marcha","phase.planning":"Planificando","phase.waiting":"Le espera a usted","phase.running":"En marcha","phase.holding":"Deteniendo","phase.held":"Detenido","phase.question":"Una pregunta para usted","phase.needs-help":"Necesita ayuda","phase.finished":"Terminado","phase.broken":"Parado por un error",progress:"{installed} de {targets} instalados","act.hold":"Detener","act.hold.note":"una petición; la parada está en la celda","act.hold.sent":"Se pidió a la celda que se detenga","act.hold.failed":"La petición no llegó a la celda. Use la parada de la celda.","act.resume":"Continuar","act.start":"Empezar","act.reject":"Rechazar","act.other":"Otra forma","act.step":"Paso a paso","act.step.note":"solo el paso {number}","act.until":"Aprobar hasta {number}","act.until.none":"Aprobar hasta …","act.all":"Aprobar todo","act.all.note.one":"{count} paso","act.all.note.other":"{count} pasos","act.show":"Ver el plan","act.cancel":"Cancelar","act.close":"Cerrar","act.send":"Enviar","act.choose":"Elegir","act.again":"Preguntar de nuevo","acts.label":"Decisiones sobre el plan {code}","wait.changed":"Acaba de cambiar","wait.differences":"Mire los cambios","wait.flagged":"Mire primero el paso {number}","wait.busy":"Se está registrando","wait.until":"elija un paso","role.lacks":"Su función ({role}) no permite esto","done.approved":"Registrado: aprobado por {who}","done.rejected":"Registrado: rechazado por {who}","done.other":"Registrado: {who}","done.unknown":"No llegó respuesta. Aún no se sabe si quedó registrado.","stale.title":"El plan cambió","stale.open":"No se aprobó nada. El plan abierto es {code}.","stale.none":"No se aprobó nada. Ahora no hay ningún plan abierto.","plan.title":"Plan","plan.code":"Código","plan.duration":"Tiempo","plan.closest":"Mínima distancia","plan.short":"En resumen","plan.steps.one":"{count} paso","plan.steps.other":"{count} pasos","plan.list":"Pasos del plan","plan.changed":"Cambios desde {code}","plan.changed.none":"Qué cambió","plan.notes":"Descartado antes de llegar a este plan","plan.single":"Un paso elegido","plan.none.idle":"No hay plan abierto. Pulse «Empezar» para que se haga uno.","plan.none.planning":"Se está planificando. Ningún robot se mueve antes de su aprobación.","plan.none.running":"Los pasos aprobados están en marcha.","plan.none.held":"Detenido. Nada empieza hasta que alguien continúe.","plan.none.finished":"Todo lo que se podía construir está construido.","plan.none.other":"No hay plan abierto.","plan.robots":"Robots","step.play":"Mostrar este paso","step.why":"¿Por qué?","step.motion":"Otro movimiento","step.done":"hecho","step.running":"en marcha","step.not done":"no hecho","step.superseded":"sustituido","step.look":"Mire este paso","step.seen":"visto","step.closest":"{distance} mm entre {first} y {second}","step.distance":"{distance} mm","step.still":"no se mueve ninguna articulación","step.robot":"Robot {number}","mode.label":"Qué se muestra","mode.now":"Ahora","mode.preview":"Vista previa","mode.target":"Objetivo","mode.as-built":"Construido","view.label":"Mirar desde","view.whole":"Todo","view.top":"Arriba","view.front":"Frente","view.side":"Lado","view.robot":"Robot {number}","view.follow":"Seguir {number}","picture.label":"Imagen 3D de la celda. Los pasos y los componentes están en las listas de al lado.","picture.failed":"Este navegador no puede dibujar la imagen 3D: {reason}","picture.stale":"Robots en gris: la última imagen medida tiene {seconds} s.","picture.refused":"Así se intentó, no es la celda ahora: los dos en rojo se acercan demasiado.","picture.blockers":"Lo que estorba, en rojo.","picture.back":"Volver a la celda","picture.preview":"Vista previa: no es la celda","preview.play":"Reproducir","preview.pause":"Pausa","preview.back":"Paso atrás","preview.next":"Paso adelante","preview.start":"Al principio","preview.time":"Tiempo en el plan","preview.none":"No hay plan que mostrar.","preview.loading":"Se cargan las trayectorias.","preview.failed":"La vista previa se niega: {reason}","gantt.label":"Horario: planificado (contorno) y real (lleno)","tree.title":"Componentes","tree.list":"Componentes por capa","tree.show":"Mostrar {name}","tree.lock":"Bloquear {name}: los toques en la imagen lo atraviesan","tree.search":"Buscar un componente","layer.target":"Por construir","layer.material":"Existencias","layer.as_built":"Construido","layer.as_designed":"Solo dibujado","layer.virtual_collision":"Mantener libre","state.waiting":"espera a otros","state.ready":"listo","state.active":"en este plan","state.in-place":"en su sitio, aún sujeto","state.standing":"se sostiene solo","state.installed":"instalado","state.refused":"rechazado","state.needs-rework":"necesita retoque","state.stock":"en existencias","state.held":"en la pinza","state.used":"en uso","state.stray":"está donde nadie lo espera","state.gone":"ya no se ve","card.label":"Componente elegido","card.type":"Tipo","card.layer":"Capa","card.state":"Estado","card.material":"Material","card.parents":"Se apoya en","card.waits":"Espera a","card.made":"Hecho de","card.place":"Está en","card.operations":"Operaciones","card.operations.done":"{done} de {count} hechas","card.accessible":"accesible","card.mismatch":"No coincide con la obra","card.close":"Cerrar la ficha","reject.title":"Rechazar este plan","reject.why":"¿Por qué?","reject.step":"¿Sobre qué?","reject.whole":"Todo el plan","reject.one":"El paso {number}","reject.detail":"Diga más, si quiere","reason.wrong-component":"Componente equivocado","reason.wrong-robot":"Robot equivocado","reason.path-unsafe":"El camino parece inseguro","reason.site-differs":"La obra es distinta","reason.later":"Más tarde","reason.other":"Otra cosa","other.title":"Otra forma","other.feasible":"Qué se podría hacer ahora en su lugar","other.note":"Su elección vuelve como un plan de un paso, con su propio camino, y se pregunta otra vez.","other.price":"{seconds} s","other.none":"Ahora no se puede hacer otra cosa.","other.infeasible":"Qué no se puede hacer, y por qué","other.loading":"Se comprueba cada forma …","other.zone":"Dibujar una zona prohibida","other.motion":"Otro movimiento para el paso {number}","zone.title":"Zona prohibida","zone.text":"Los robots y las piezas no entran en esta caja. El plan abierto queda anulado y se hace otro.","zone.x":"Centro x (m)","zone.y":"Centro y (m)","zone.z":"Centro z (m)","zone.length":"Largo (m)","zone.width":"Ancho (m)","zone.height":"Alto (m)","zone.tap":"Toque la imagen para moverla allí.","zone.save":"Prohibir","mismatch.title":"{name} no coincide con la obra","mismatch.text":"La ejecución se detiene y el plan abierto queda anulado.","mismatch.detail":"¿Qué es distinto?","help.title":"Necesita ayuda","help.pair":"Se estorban: {first} y {second}","help.options":"Qué se puede hacer","help.show":"Mostrarlo","verdict.proven":"Está demostrado que nada en este proyecto puede hacerlo: ningún robot, agarre ni orden. Cambie el modelo o la celda.","verdict.blocked":"Algo estorba. Sin eso quizá se encuentre un camino.","verdict.not-found":"La búsqueda acabó sin camino; aun así puede haber uno.","verdict.person":"Hasta entonces la ejecución no lo toca.","verdict.rejected":"Una persona dijo que no, y no se encontró otro plan. Se puede volver a pedir el mismo plan; nada se hace sin un sí.","verdict.wish":"Vuelve cuando todo lo demás esté hecho, o en la próxima ejecución.","help.tried":"Probado en una copia, y funciona:","help.tried-one":"{words} ({steps} pasos, {seconds} s)","help.none":"No se conoce salida. Cambie el modelo o la celda y continúe.","help.manual":"Hecho a mano","question.title":"¿Ocurrió?","answer.done":"Sí, está hecho","answer.not-done":"No, no está hecho","answer.partial":"Solo en parte","manual.title":"{name} se hizo a mano","manual.text":"Marque lo que ahora es cierto. La ejecución le cree y mira lo que puede medir.","building.order":"Orden de construcción","building.slider":"Número de componentes en pie","building.shown":"{count} de {total} en pie","building.graph":"Qué se apoya en qué","building.graph.label":"Grafo de relaciones: elija un componente","building.jobsite":"Obra","runs.title":"Ejecuciones de este proyecto","runs.none":"Aún no hay ninguna.","runs.open":"abierta","runs.complete":"completa","runs.finished":"terminada","runs.held":"detenida","runs.report":"Informe","runs.installed":"{installed} de {targets} instalados","runs.events":"Qué ocurrió","runs.choose":"Elija una ejecución para ver qué ocurrió.","audit.title":"Quién decidió qué, cuándo y sobre qué","audit.none":"Aún no se ha decidido nada.","audit.when":"Cuándo","audit.who":"Quién","audit.what":"Qué","audit.code":"Plan","audit.seen":"Texto que se vio","health.title":"Estado","health.server":"Servidor","health.run":"Ejecución","health.cell":"Celda","health.journal":"Diario","health.disk":"Espacio libre en disco","health.uptime":"activo desde hace {seconds} s","health.clients.one":"{count} página abierta","health.clients.other":"{count} páginas abiertas","health.whole":"cadena de hashes íntegra","health.not-whole":"cadena de hashes rota","health.alive":"vivo","health.dead":"no está","health.page":"Esta página","health.frame":"{ms} ms de script por imagen, {calls} llamadas de dibujo","journal.title":"Diario","journal.none":"No ha ocurrido nada desde que se abrió esta página.","view.open":"Vista","done.second":"Anotado. Una segunda persona debe decidir lo mismo.",fault:"Esta parte de la página ha fallado: {reason}. No afecta a los robots; Detener sigue funcionando.","fault.reload":"Cargar la página de nuevo","zone.remove":"Quitar la zona prohibida","picture.replay":"Repetición: no es la celda de ahora","verb.approve":"Aprobó","verb.reject":"Rechazó","verb.instead":"Eligió otra acción","verb.new-motion":"Pidió otro movimiento","verb.hold":"Detuvo","verb.resume":"Continuó","verb.answer":"Respondió","verb.mismatch":"Dijo que la obra es distinta","verb.zone":"Cambió zonas prohibidas","verb.manual":"Lo hizo a mano","scope.plan":"todo el plan","scope.until":"hasta el paso {step}","scope.step":"solo el paso {step}","tree.zones":"Zonas prohibidas","sign-in.user":"Nombre","sign-in.token":"Token","sign-in.go":"Entrar","sign-in.or":"O entre con su nombre y su propio token:","pin.title":"¿Quién decide?","pin.pin":"PIN",loading:"Cargando …",failed:"No funcionó: {reason}"};var ef={"app.name":"Sitewright","nav.cell":"工作单元","nav.building":"建筑","nav.runs":"运行","nav.audit":"审计","nav.health":"状态","nav.label":"页面",language:"语言",safety:"本页面不是安全装置。","link.connecting":"正在连接","link.live":"实时","link.stale":"画面已过时：{seconds} 秒","link.absent":"没有工作单元","link.lost":"没有连接","lost.title":"没有连接。","lost.text":"本页面现在既不能显示也不能暂停机器人。请使用工作单元上的停止按钮。","lost.note":"给自己的备注（只留在本页）","signed-out.title":"本页面尚未登录","signed-out.text":"请打开 sitewright serve 显示的链接。它只能用一次；重新启动命令可得到新的链接。",broken:"运行因错误而停止。","phase.idle":"没有任务进行","phase.planning":"正在规划","phase.waiting":"等待您的决定","phase.running":"正在执行","phase.holding":"正在暂停","phase.held":"已暂停","phase.question":"有问题要问您","phase.needs-help":"需要帮助","phase.finished":"已完成","phase.broken":"因错误停止",progress:"已安装 {installed}/{targets}","act.hold":"暂停","act.hold.note":"只是请求；停止按钮在工作单元上","act.hold.sent":"已请求工作单元暂停","act.hold.failed":"请求没有到达工作单元。请使用工作单元上的停止按钮。","act.resume":"继续","act.start":"开始","act.reject":"拒绝","act.other":"其他方式","act.step":"逐步","act.step.note":"仅第 {number} 步","act.until":"批准到第 {number} 步","act.until.none":"批准到……","act.all":"全部批准","act.all.note.one":"{count} 步","act.all.note.other":"{count} 步","act.show":"查看方案","act.cancel":"取消","act.close":"关闭","act.send":"发送","act.choose":"选择","act.again":"再问一次","acts.label":"对方案 {code} 的决定","wait.changed":"方案刚刚改变","wait.differences":"请先看改变之处","wait.flagged":"请先看第 {number} 步","wait.busy":"正在记录","wait.until":"请选择一步","role.lacks":"您的角色（{role}）不能这样做","done.approved":"已记录：由 {who} 批准","done.rejected":"已记录：由 {who} 拒绝","done.other":"已记录：{who}","done.unknown":"没有收到答复。尚不知道是否已记录。","stale.title":"方案已改变","stale.open":"没有批准任何内容。当前方案是 {code}。","stale.none":"没有批准任何内容。当前没有方案。","plan.title":"方案","plan.code":"核对码","plan.duration":"时间","plan.closest":"最近距离","plan.short":"概要","plan.steps.one":"{count} 步","plan.steps.other":"{count} 步","plan.list":"方案的步骤","plan.changed":"自 {code} 以来的改变","plan.changed.none":"改变之处","plan.notes":"得出此方案之前被否定的","plan.single":"一个选定的步骤","plan.none.idle":"没有方案。按“开始”让规划器做一个。","plan.none.planning":"正在规划。在您批准之前，机器人不会移动。","plan.none.running":"已批准的步骤正在执行。","plan.none.held":"已暂停。有人按继续之前，什么都不会开始。","plan.none.finished":"能建的都已建成。","plan.none.other":"没有方案。","plan.robots":"机器人","step.play":"演示这一步","step.why":"为什么？","step.motion":"换一种动作","step.done":"完成","step.running":"执行中","step.not done":"未完成","step.superseded":"已被取代","step.look":"请看这一步","step.seen":"已看","step.closest":"{first} 与 {second} 之间 {distance} 毫米","step.distance":"{distance} 毫米","step.still":"关节不动","step.robot":"机器人 {number}","mode.label":"显示内容","mode.now":"现在","mode.preview":"预演","mode.target":"目标","mode.as-built":"已建成","view.label":"视角","view.whole":"全部","view.top":"俯视","view.front":"正面","view.side":"侧面","view.robot":"机器人 {number}","view.follow":"跟随 {number}","picture.label":"工作单元的三维图。步骤和构件见旁边的列表。","picture.failed":"此浏览器无法绘制三维图：{reason}","picture.stale":"机器人显示为灰色：最近的测量画面已有 {seconds} 秒。","picture.refused":"这是尝试时的情形，不是现在的工作单元：红色的两者靠得太近。","picture.blockers":"挡路的物体以红色显示。","picture.back":"返回工作单元","picture.preview":"预演：不是实际工作单元","preview.play":"播放","preview.pause":"停下","preview.back":"上一步","preview.next":"下一步","preview.start":"回到开头","preview.time":"方案中的时间","preview.none":"没有可以预演的方案。","preview.loading":"正在载入轨迹。","preview.failed":"拒绝预演：{reason}","gantt.label":"进度：计划（轮廓）与实际（实心）","tree.title":"构件","tree.list":"按图层排列的构件","tree.show":"显示 {name}","tree.lock":"锁定 {name}：点击图像时穿过它","tree.search":"查找构件","layer.target":"待建","layer.material":"库存","layer.as_built":"已建成","layer.as_designed":"仅图纸","layer.virtual_collision":"保持净空","state.waiting":"等待其他构件","state.ready":"就绪","state.active":"在此方案中","state.in-place":"就位，仍被夹持","state.standing":"自行稳定","state.installed":"已安装","state.refused":"被拒绝","state.needs-rework":"需要返工","state.stock":"库存中","state.held":"在夹爪中","state.used":"使用中","state.stray":"不在预期的位置","state.gone":"已看不到","card.label":"选中的构件","card.type":"类型","card.layer":"图层","card.state":"状态","card.material":"材料","card.parents":"支承于","card.waits":"等待","card.made":"用料","card.place":"位于","card.operations":"工序","card.operations.done":"已完成 {done}/{count}","card.accessible":"可取","card.mismatch":"与现场不符","card.close":"关闭卡片","reject.title":"拒绝此方案","reject.why":"为什么？","reject.step":"针对什么？","reject.whole":"整个方案","reject.one":"第 {number} 步","reject.detail":"如有需要，请说明","reason.wrong-component":"构件不对","reason.wrong-robot":"机器人不对","reason.path-unsafe":"路径看起来不安全","reason.site-differs":"现场情况不同","reason.later":"以后再做","reason.other":"其他","other.title":"其他方式","other.feasible":"现在可以改做什么","other.note":"您的选择会作为只有一步、有自己路径的方案回来，并再次征求同意。","other.price":"{seconds} 秒","other.none":"现在不能做别的。","other.infeasible":"不能做什么，为什么","other.loading":"正在检查每种方式……","other.zone":"画禁入区","other.motion":"第 {number} 步换一种动作","zone.title":"禁入区","zone.text":"机器人和构件不进入此长方体。当前方案作废并重新规划。","zone.x":"中心 x（米）","zone.y":"中心 y（米）","zone.z":"中心 z（米）","zone.length":"长（米）","zone.width":"宽（米）","zone.height":"高（米）","zone.tap":"点击图像可移到该处。","zone.save":"禁入","mismatch.title":"{name} 与现场不符","mismatch.text":"运行将暂停，当前方案作废。","mismatch.detail":"有什么不同？","help.title":"需要帮助","help.pair":"相互妨碍：{first} 与 {second}","help.options":"可以怎么做","help.show":"显示","verdict.proven":"已证明本项目中没有办法做到：没有机器人、抓法或顺序可行。请修改模型或工作单元。","verdict.blocked":"有东西挡路。移开之后也许能找到办法。","verdict.not-found":"搜索结束时没有找到办法，但不等于没有。","verdict.person":"在那之前运行不会碰它。","verdict.rejected":"有人拒绝了，且没有找到别的方案。可以再次提出同一方案；没有同意就什么也不做。","verdict.wish":"其他都做完后，或在下次运行时再做。","help.tried":"已在副本上试过，可行：","help.tried-one":"{words}（{steps} 步，{seconds} 秒）","help.none":"没有已知的办法。请修改模型或工作单元，然后继续。","help.manual":"已人工完成","question.title":"发生了吗？","answer.done":"是，已完成","answer.not-done":"否，未完成","answer.partial":"只完成一部分","manual.title":"{name} 已人工完成","manual.text":"请勾选现在属实的内容。运行相信您，并检查能测量的部分。","building.order":"建造顺序","building.slider":"已立构件数","building.shown":"已立 {count}/{total}","building.graph":"支承关系","building.graph.label":"建造关系图：选择构件","building.jobsite":"工地","runs.title":"本项目的运行","runs.none":"还没有运行。","runs.open":"进行中","runs.complete":"全部完成","runs.finished":"已结束","runs.held":"已暂停","runs.report":"报告","runs.installed":"已安装 {installed}/{targets}","runs.events":"经过","runs.choose":"选择一次运行，查看经过。","audit.title":"谁在何时就什么作了什么决定","audit.none":"还没有任何决定。","audit.when":"时间","audit.who":"谁","audit.what":"内容","audit.code":"方案","audit.seen":"当时看到的文字","health.title":"状态","health.server":"服务器","health.run":"运行","health.cell":"工作单元","health.journal":"日志","health.disk":"磁盘剩余空间","health.uptime":"已运行 {seconds} 秒","health.clients.one":"打开 {count} 个页面","health.clients.other":"打开 {count} 个页面","health.whole":"哈希链完整","health.not-whole":"哈希链断裂","health.alive":"正常","health.dead":"不在","health.page":"本页面","health.frame":"每幅画面脚本 {ms} 毫秒，绘制调用 {calls} 次","journal.title":"日志","journal.none":"打开本页面以来没有发生任何事。","view.open":"视图","done.second":"已记下。还需要第二个人作出同样的决定。",fault:"页面的这一部分出错：{reason}。机器人不受影响；暂停仍然可用。","fault.reload":"重新载入页面","zone.remove":"取消禁入区","picture.replay":"重放：不是现在的工作单元","verb.approve":"批准","verb.reject":"拒绝","verb.instead":"选择了其他动作","verb.new-motion":"要求换一种动作","verb.hold":"暂停","verb.resume":"继续","verb.answer":"回答","verb.mismatch":"指出现场不同","verb.zone":"更改了禁入区","verb.manual":"人工完成","scope.plan":"整个方案","scope.until":"到第 {step} 步","scope.step":"仅第 {step} 步","tree.zones":"禁入区","sign-in.user":"姓名","sign-in.token":"令牌","sign-in.go":"登录","sign-in.or":"或用姓名和自己的令牌登录：","pin.title":"由谁决定？","pin.pin":"PIN 码",loading:"正在载入……",failed:"未能完成：{reason}"};var rh={en:"English",de:"Deutsch",es:"Español",zh:"中文"},tf={en:Kd,de:Jd,es:Qd,zh:ef},nf="sitewright-language",Gt=we(m_());Ze(()=>{document.documentElement.lang=Gt.value});var f_=bn(()=>new Intl.PluralRules(Gt.value));function p_(n){return n!=null&&n in rh}function m_(){return[new URLSearchParams(location.search).get("lang"),localStorage.getItem(nf),...navigator.languages.map(t=>t.slice(0,2))].find(p_)??"en"}function sf(n){localStorage.setItem(nf,n),Gt.value=n}function A(n,e={}){return tf[Gt.value][n].replace(/\{(\w+)\}/g,(t,i)=>{let s=e[i];return s===void 0?t:String(s)})}function us(n,e){let t=f_.value.select(e)==="one"?"one":"other";return A(`${n}.${t}`,{count:Dt(e)})}function sn(n,e){let t=`${n}.${e}`;return t in tf.en?A(t):e}function Dt(n,e=0){return new Intl.NumberFormat(Gt.value,{maximumFractionDigits:e,minimumFractionDigits:e}).format(n)}function Ni(n){return`${Dt(n,n<10&&n>0?1:0)} s`}function Ur(n){return Dt(n*1e3)}function ds(n){let e=Gt.value==="en"?"en-GB":Gt.value;return new Intl.DateTimeFormat(e,{dateStyle:"short",timeStyle:"medium"}).format(n)}var Ui=class extends Error{constructor(t,i){super(i.message);this.status=t;this.refusal=i}status;refusal},fs=class extends Error{};async function lt(n,{method:e="GET",body:t,wait_ms:i=8e3}={}){let s=await lf(n,e,t,i),r=await s.json().catch(()=>null);if(s.ok)return r;throw new Ui(s.status,r??{error:"unreadable",message:`${s.status} ${s.statusText}`})}async function rf(n){return(await af(n)).arrayBuffer()}async function of(n){return(await af(n)).text()}async function af(n){let e=await lf(n,"GET",void 0,2e4);if(!e.ok)throw new Ui(e.status,{error:"unreadable",message:`${n}: ${e.status}`});return e}function Jt(n){return`${n}${n.includes("?")?"&":"?"}lang=${Gt.value}`}async function lf(n,e,t,i){let s=e==="POST";try{return await fetch(n,{method:e,headers:s?{"content-type":"application/json"}:{},body:s?JSON.stringify(t??{}):null,credentials:"same-origin",signal:AbortSignal.timeout(i)})}catch(r){throw new fs(r instanceof Error?r.message:String(r))}}var cf=new URLSearchParams(location.search),Fs=cf.get("freeze")==="1",hf=Number(cf.get("dpr")??Math.min(devicePixelRatio,2)),g_=240;window.__m={marks:{},cost:{js_ms:0,calls:0},costs:[]};function ia(n){window.__m.marks[n]??=performance.now()}function uf(n){window.__m.cost={...n},window.__m.costs.push(n.js_ms),window.__m.costs.length>g_&&window.__m.costs.shift()}var $i={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ji={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Yf=0,kh=1,Zf=2;var xs=1,$f=2,ur=3,Ji=0,vn=1,yn=2,bs=0,dr=1,zh=2,Gh=3,Vh=4,jf=5;var Ss=100,Jf=101,Kf=102,Qf=103,ep=104,tp=200,np=201,ip=202,sp=203,Hh=204,Wh=205,rp=206,op=207,ap=208,lp=209,cp=210,hp=211,up=212,dp=213,fp=214,La=0,Da=1,Na=2,er=3,Ua=4,Oa=5,Fa=6,Ba=7,gl=0,pp=1,mp=2,Vn=0,Xh=1,qh=2,Yh=3,Zh=4,$h=5,jh=6,Jh=7;var Kh=300,Ms=301,fr=302,_l=303,vl=304,tr=1e3,si=1001,ka=1002,Qt=1003,gp=1004;var So=1005;var gn=1006,yl=1007;var wi=1008;var Mn=1009,Qh=1010,eu=1011,pr=1012,xl=1013,jn=1014,Hn=1015,Jn=1016,bl=1017,Sl=1018,ws=1020,tu=35902,nu=35899,iu=1021,su=1022,Kn=1023,vi=1026,Ti=1027,Ml=1028,wl=1029,Ki=1030,Tl=1031;var El=1033,Mo=33776,wo=33777,To=33778,Eo=33779,Al=35840,Rl=35841,Cl=35842,Pl=35843,Il=36196,Ll=37492,Dl=37496,Nl=37488,Ul=37489,Ao=37490,Ol=37491,Fl=37808,Bl=37809,kl=37810,zl=37811,Gl=37812,Vl=37813,Hl=37814,Wl=37815,Xl=37816,ql=37817,Yl=37818,Zl=37819,$l=37820,jl=37821,Jl=36492,Kl=36494,Ql=36495,ec=36283,tc=36284,Ro=36285,nc=36286;var Yr=2300,za=2301,Pa=2302,Ih=2303,Lh=2400,Dh=2401,Nh=2402;var _p=3200;var ic=0,vp=1,Ei="",Rn="srgb",Zr="srgb-linear",$r="linear",rt="srgb";var Ia=7680;var yp=519,xp=512,bp=513,Sp=514,ru=515,Mp=516,wp=517,ou=518,au=519,Tp=35044;var lu="300 es",kn=2e3,nr=2001;function __(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function v_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function jr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ep(){let n=jr("canvas");return n.style.display="block",n}var df={},ir=null;function cu(...n){let e="THREE."+n.shift();ir?ir("log",e,...n):console.log(e,...n)}function Ap(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ce(...n){n=Ap(n);let e="THREE."+n.shift();if(ir)ir("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function De(...n){n=Ap(n);let e="THREE."+n.shift();if(ir)ir("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Hr(...n){let e=n.join(" ");e in df||(df[e]=!0,Ce(...n))}function Rp(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Cp={[La]:La,[Na]:Fa,[Ua]:Ua,[er]:Oa,[Da]:Da,[Fa]:Na,[Ba]:Ba,[Oa]:er},$n=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},ln=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ff=1234567,Ks=Math.PI/180,sr=180/Math.PI;function mr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ln[n&255]+ln[n>>8&255]+ln[n>>16&255]+ln[n>>24&255]+"-"+ln[e&255]+ln[e>>8&255]+"-"+ln[e>>16&15|64]+ln[e>>24&255]+"-"+ln[t&63|128]+ln[t>>8&255]+"-"+ln[t>>16&255]+ln[t>>24&255]+ln[i&255]+ln[i>>8&255]+ln[i>>16&255]+ln[i>>24&255]).toLowerCase()}function Ve(n,e,t){return Math.max(e,Math.min(t,n))}function hu(n,e){return(n%e+e)%e}function y_(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function x_(n,e,t){return n!==e?(t-n)/(e-n):0}function Wr(n,e,t){return(1-t)*n+t*e}function b_(n,e,t,i){return Wr(n,e,1-Math.exp(-t*i))}function S_(n,e=1){return e-Math.abs(hu(n,e*2)-e)}function M_(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function w_(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function T_(n,e){return n+Math.floor(Math.random()*(e-n+1))}function E_(n,e){return n+Math.random()*(e-n)}function A_(n){return n*(.5-Math.random())}function R_(n){n!==void 0&&(ff=n);let e=ff+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function C_(n){return n*Ks}function P_(n){return n*sr}function I_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function L_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function uu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function D_(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),c=o(t/2),l=r((e+i)/2),h=o((e+i)/2),f=r((e-i)/2),d=o((e-i)/2),u=r((i-e)/2),_=o((i-e)/2);switch(s){case"XYX":n.set(a*h,c*f,c*d,a*l);break;case"YZY":n.set(c*d,a*h,c*f,a*l);break;case"ZXZ":n.set(c*f,c*d,a*h,a*l);break;case"XZX":n.set(a*h,c*_,c*u,a*l);break;case"YXY":n.set(c*u,a*h,c*_,a*l);break;case"ZYZ":n.set(c*_,c*u,a*h,a*l);break;default:Ce("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function du(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Pp(n,e){if(e.constructor===Float32Array)return n;let t=du(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Ip(n,e){if(e.constructor===Float32Array)return n;let t=du(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var gr={DEG2RAD:Ks,RAD2DEG:sr,generateUUID:mr,clamp:Ve,euclideanModulo:hu,mapLinear:y_,inverseLerp:x_,lerp:Wr,damp:b_,pingpong:S_,smoothstep:M_,smootherstep:w_,randInt:T_,randFloat:E_,randFloatSpread:A_,seededRandom:R_,degToRad:C_,radToDeg:P_,isPowerOfTwo:I_,ceilPowerOfTwo:L_,floorPowerOfTwo:uu,setQuaternionFromProperEuler:D_,normalize:Ip,denormalize:Pp},ye=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ve(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},rn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let c=i[s+0],l=i[s+1],h=i[s+2],f=i[s+3],d=r[o+0],u=r[o+1],_=r[o+2],b=r[o+3];if(f!==b||c!==d||l!==u||h!==_){let m=c*d+l*u+h*_+f*b;m<0&&(d=-d,u=-u,_=-_,b=-b,m=-m);let g=1-a;if(m<.9995){let S=Math.acos(m),E=Math.sin(S);g=Math.sin(g*S)/E,a=Math.sin(a*S)/E,c=c*g+d*a,l=l*g+u*a,h=h*g+_*a,f=f*g+b*a}else{c=c*g+d*a,l=l*g+u*a,h=h*g+_*a,f=f*g+b*a;let S=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=S,l*=S,h*=S,f*=S}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],h=i[s+3],f=r[o],d=r[o+1],u=r[o+2],_=r[o+3];return e[t]=a*_+h*f+c*u-l*d,e[t+1]=c*_+h*d+l*f-a*u,e[t+2]=l*_+h*u+a*d-c*f,e[t+3]=h*_-a*f-c*d-l*u,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(s/2),f=a(r/2),d=c(i/2),u=c(s/2),_=c(r/2);switch(o){case"XYZ":this._x=d*h*f+l*u*_,this._y=l*u*f-d*h*_,this._z=l*h*_+d*u*f,this._w=l*h*f-d*u*_;break;case"YXZ":this._x=d*h*f+l*u*_,this._y=l*u*f-d*h*_,this._z=l*h*_-d*u*f,this._w=l*h*f+d*u*_;break;case"ZXY":this._x=d*h*f-l*u*_,this._y=l*u*f+d*h*_,this._z=l*h*_+d*u*f,this._w=l*h*f-d*u*_;break;case"ZYX":this._x=d*h*f-l*u*_,this._y=l*u*f+d*h*_,this._z=l*h*_-d*u*f,this._w=l*h*f+d*u*_;break;case"YZX":this._x=d*h*f+l*u*_,this._y=l*u*f+d*h*_,this._z=l*h*_-d*u*f,this._w=l*h*f-d*u*_;break;case"XZY":this._x=d*h*f-l*u*_,this._y=l*u*f-d*h*_,this._z=l*h*_+d*u*f,this._w=l*h*f+d*u*_;break;default:Ce("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],f=t[10],d=i+a+f;if(d>0){let u=.5/Math.sqrt(d+1);this._w=.25/u,this._x=(h-c)*u,this._y=(r-l)*u,this._z=(o-s)*u}else if(i>a&&i>f){let u=2*Math.sqrt(1+i-a-f);this._w=(h-c)/u,this._x=.25*u,this._y=(s+o)/u,this._z=(r+l)/u}else if(a>f){let u=2*Math.sqrt(1+a-i-f);this._w=(r-l)/u,this._x=(s+o)/u,this._y=.25*u,this._z=(c+h)/u}else{let u=2*Math.sqrt(1+f-i-a);this._w=(o-s)/u,this._x=(r+l)/u,this._y=(c+h)/u,this._z=.25*u}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ve(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=i*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-s*a,this._w=o*h-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+i*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(pf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(pf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*i),h=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+c*l+o*f-a*h,this.y=i+c*h+a*l-r*f,this.z=s+c*f+r*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return oh.copy(this).projectOnVector(e),this.sub(oh)}reflect(e){return this.sub(oh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ve(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},oh=new P,pf=new rn,Ne=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,c,l)}set(e,t,i,s,r,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],f=i[7],d=i[2],u=i[5],_=i[8],b=s[0],m=s[3],g=s[6],S=s[1],E=s[4],M=s[7],C=s[2],R=s[5],v=s[8];return r[0]=o*b+a*S+c*C,r[3]=o*m+a*E+c*R,r[6]=o*g+a*M+c*v,r[1]=l*b+h*S+f*C,r[4]=l*m+h*E+f*R,r[7]=l*g+h*M+f*v,r[2]=d*b+u*S+_*C,r[5]=d*m+u*E+_*R,r[8]=d*g+u*M+_*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-i*r*h+i*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=h*o-a*l,d=a*c-h*r,u=l*r-o*c,_=t*f+i*d+s*u;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/_;return e[0]=f*b,e[1]=(s*l-h*i)*b,e[2]=(a*i-s*o)*b,e[3]=d*b,e[4]=(h*t-s*c)*b,e[5]=(s*r-a*t)*b,e[6]=u*b,e[7]=(i*c-l*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Hr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ah.makeScale(e,t)),this}rotate(e){return Hr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ah.makeRotation(-e)),this}translate(e,t){return Hr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ah.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ah=new Ne,mf=new Ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),gf=new Ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function N_(){let n={enabled:!0,workingColorSpace:Zr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===rt&&(s.r=_i(s.r),s.g=_i(s.g),s.b=_i(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===rt&&(s.r=Qs(s.r),s.g=Qs(s.g),s.b=Qs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ei?$r:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Zr]:{primaries:e,whitePoint:i,transfer:$r,toXYZ:mf,fromXYZ:gf,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Rn},outputColorSpaceConfig:{drawingBufferColorSpace:Rn}},[Rn]:{primaries:e,whitePoint:i,transfer:rt,toXYZ:mf,fromXYZ:gf,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Rn}}}),n}var Ke=N_();function _i(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Qs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Bs,Ga=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Bs===void 0&&(Bs=jr("canvas")),Bs.width=e.width,Bs.height=e.height;let s=Bs.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Bs}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=jr("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=_i(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(_i(t[i]/255)*255):t[i]=_i(t[i]);return{data:t,width:e.width,height:e.height}}else return Ce("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},U_=0,rr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:U_++}),this.uuid=mr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(lh(s[o].image)):r.push(lh(s[o]))}else r=lh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function lh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ga.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ce("Texture: Unable to serialize Texture."),{})}var O_=0,ch=new P,_n=class n extends $n{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=si,s=si,r=gn,o=wi,a=Kn,c=Mn,l=n.DEFAULT_ANISOTROPY,h=Ei){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:O_++}),this.uuid=mr(),this.name="",this.source=new rr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new ye(0,0),this.repeat=new ye(1,1),this.center=new ye(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ne,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ch).x}get height(){return this.source.getSize(ch).y}get depth(){return this.source.getSize(ch).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ce(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ce(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Kh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case tr:e.x=e.x-Math.floor(e.x);break;case si:e.x=e.x<0?0:1;break;case ka:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case tr:e.y=e.y-Math.floor(e.y);break;case si:e.y=e.y<0?0:1;break;case ka:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};_n.DEFAULT_IMAGE=null;_n.DEFAULT_MAPPING=Kh;_n.DEFAULT_ANISOTROPY=1;var bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,c=e.elements,l=c[0],h=c[4],f=c[8],d=c[1],u=c[5],_=c[9],b=c[2],m=c[6],g=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-b)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+b)<.1&&Math.abs(_+m)<.1&&Math.abs(l+u+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(l+1)/2,M=(u+1)/2,C=(g+1)/2,R=(h+d)/4,v=(f+b)/4,w=(_+m)/4;return E>M&&E>C?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=R/i,r=v/i):M>C?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=R/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=v/r,s=w/r),this.set(i,s,r,t),this}let S=Math.sqrt((m-_)*(m-_)+(f-b)*(f-b)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(m-_)/S,this.y=(f-b)/S,this.z=(d-h)/S,this.w=Math.acos((l+u+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this.w=Ve(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this.w=Ve(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Va=class extends $n{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:gn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new bt(0,0,e,t),this.scissorTest=!1,this.viewport=new bt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new _n({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:gn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new rr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},In=class extends Va{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Jr=class extends _n{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=si,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ha=class extends _n{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Qt,this.minFilter=Qt,this.wrapR=si,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var qe=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,c,l,h,f,d,u,_,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,c,l,h,f,d,u,_,b,m)}set(e,t,i,s,r,o,a,c,l,h,f,d,u,_,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=h,g[10]=f,g[14]=d,g[3]=u,g[7]=_,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/ks.setFromMatrixColumn(e,0).length(),r=1/ks.setFromMatrixColumn(e,1).length(),o=1/ks.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let d=o*h,u=o*f,_=a*h,b=a*f;t[0]=c*h,t[4]=-c*f,t[8]=l,t[1]=u+_*l,t[5]=d-b*l,t[9]=-a*c,t[2]=b-d*l,t[6]=_+u*l,t[10]=o*c}else if(e.order==="YXZ"){let d=c*h,u=c*f,_=l*h,b=l*f;t[0]=d+b*a,t[4]=_*a-u,t[8]=o*l,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=u*a-_,t[6]=b+d*a,t[10]=o*c}else if(e.order==="ZXY"){let d=c*h,u=c*f,_=l*h,b=l*f;t[0]=d-b*a,t[4]=-o*f,t[8]=_+u*a,t[1]=u+_*a,t[5]=o*h,t[9]=b-d*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let d=o*h,u=o*f,_=a*h,b=a*f;t[0]=c*h,t[4]=_*l-u,t[8]=d*l+b,t[1]=c*f,t[5]=b*l+d,t[9]=u*l-_,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let d=o*c,u=o*l,_=a*c,b=a*l;t[0]=c*h,t[4]=b-d*f,t[8]=_*f+u,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=u*f+_,t[10]=d-b*f}else if(e.order==="XZY"){let d=o*c,u=o*l,_=a*c,b=a*l;t[0]=c*h,t[4]=-f,t[8]=l*h,t[1]=d*f+b,t[5]=o*h,t[9]=u*f-_,t[2]=_*f-u,t[6]=a*h,t[10]=b*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(F_,e,B_)}lookAt(e,t,i){let s=this.elements;return En.subVectors(e,t),En.lengthSq()===0&&(En.z=1),En.normalize(),Oi.crossVectors(i,En),Oi.lengthSq()===0&&(Math.abs(i.z)===1?En.x+=1e-4:En.z+=1e-4,En.normalize(),Oi.crossVectors(i,En)),Oi.normalize(),sa.crossVectors(En,Oi),s[0]=Oi.x,s[4]=sa.x,s[8]=En.x,s[1]=Oi.y,s[5]=sa.y,s[9]=En.y,s[2]=Oi.z,s[6]=sa.z,s[10]=En.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],f=i[5],d=i[9],u=i[13],_=i[2],b=i[6],m=i[10],g=i[14],S=i[3],E=i[7],M=i[11],C=i[15],R=s[0],v=s[4],w=s[8],B=s[12],N=s[1],O=s[5],G=s[9],W=s[13],D=s[2],Y=s[6],K=s[10],H=s[14],ie=s[3],q=s[7],ee=s[11],te=s[15];return r[0]=o*R+a*N+c*D+l*ie,r[4]=o*v+a*O+c*Y+l*q,r[8]=o*w+a*G+c*K+l*ee,r[12]=o*B+a*W+c*H+l*te,r[1]=h*R+f*N+d*D+u*ie,r[5]=h*v+f*O+d*Y+u*q,r[9]=h*w+f*G+d*K+u*ee,r[13]=h*B+f*W+d*H+u*te,r[2]=_*R+b*N+m*D+g*ie,r[6]=_*v+b*O+m*Y+g*q,r[10]=_*w+b*G+m*K+g*ee,r[14]=_*B+b*W+m*H+g*te,r[3]=S*R+E*N+M*D+C*ie,r[7]=S*v+E*O+M*Y+C*q,r[11]=S*w+E*G+M*K+C*ee,r[15]=S*B+E*W+M*H+C*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],f=e[6],d=e[10],u=e[14],_=e[3],b=e[7],m=e[11],g=e[15],S=c*u-l*d,E=a*u-l*f,M=a*d-c*f,C=o*u-l*h,R=o*d-c*h,v=o*f-a*h;return t*(b*S-m*E+g*M)-i*(_*S-m*C+g*R)+s*(_*E-b*C+g*v)-r*(_*M-b*R+m*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-i*(r*h-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],f=e[9],d=e[10],u=e[11],_=e[12],b=e[13],m=e[14],g=e[15],S=t*a-i*o,E=t*c-s*o,M=t*l-r*o,C=i*c-s*a,R=i*l-r*a,v=s*l-r*c,w=h*b-f*_,B=h*m-d*_,N=h*g-u*_,O=f*m-d*b,G=f*g-u*b,W=d*g-u*m,D=S*W-E*G+M*O+C*N-R*B+v*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let Y=1/D;return e[0]=(a*W-c*G+l*O)*Y,e[1]=(s*G-i*W-r*O)*Y,e[2]=(b*v-m*R+g*C)*Y,e[3]=(d*R-f*v-u*C)*Y,e[4]=(c*N-o*W-l*B)*Y,e[5]=(t*W-s*N+r*B)*Y,e[6]=(m*M-_*v-g*E)*Y,e[7]=(h*v-d*M+u*E)*Y,e[8]=(o*G-a*N+l*w)*Y,e[9]=(i*N-t*G-r*w)*Y,e[10]=(_*R-b*M+g*S)*Y,e[11]=(f*M-h*R-u*S)*Y,e[12]=(a*B-o*O-c*w)*Y,e[13]=(t*O-i*B+s*w)*Y,e[14]=(b*E-_*C-m*S)*Y,e[15]=(h*C-f*E+d*S)*Y,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,c=e.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+i,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,h=o+o,f=a+a,d=r*l,u=r*h,_=r*f,b=o*h,m=o*f,g=a*f,S=c*l,E=c*h,M=c*f,C=i.x,R=i.y,v=i.z;return s[0]=(1-(b+g))*C,s[1]=(u+M)*C,s[2]=(_-E)*C,s[3]=0,s[4]=(u-M)*R,s[5]=(1-(d+g))*R,s[6]=(m+S)*R,s[7]=0,s[8]=(_+E)*v,s[9]=(m-S)*v,s[10]=(1-(d+b))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=ks.set(s[0],s[1],s[2]).length(),a=ks.set(s[4],s[5],s[6]).length(),c=ks.set(s[8],s[9],s[10]).length();r<0&&(o=-o),qn.copy(this);let l=1/o,h=1/a,f=1/c;return qn.elements[0]*=l,qn.elements[1]*=l,qn.elements[2]*=l,qn.elements[4]*=h,qn.elements[5]*=h,qn.elements[6]*=h,qn.elements[8]*=f,qn.elements[9]*=f,qn.elements[10]*=f,t.setFromRotationMatrix(qn),i.x=o,i.y=a,i.z=c,this}makePerspective(e,t,i,s,r,o,a=kn,c=!1){let l=this.elements,h=2*r/(t-e),f=2*r/(i-s),d=(t+e)/(t-e),u=(i+s)/(i-s),_,b;if(c)_=r/(o-r),b=o*r/(o-r);else if(a===kn)_=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===nr)_=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=u,l[13]=0,l[2]=0,l[6]=0,l[10]=_,l[14]=b,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=kn,c=!1){let l=this.elements,h=2/(t-e),f=2/(i-s),d=-(t+e)/(t-e),u=-(i+s)/(i-s),_,b;if(c)_=1/(o-r),b=o/(o-r);else if(a===kn)_=-2/(o-r),b=-(o+r)/(o-r);else if(a===nr)_=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=u,l[2]=0,l[6]=0,l[10]=_,l[14]=b,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ks=new P,qn=new qe,F_=new P(0,0,0),B_=new P(1,1,1),Oi=new P,sa=new P,En=new P,_f=new qe,vf=new rn,yi=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],u=s[10];switch(t){case"XYZ":this._y=Math.asin(Ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,u),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,u),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ve(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,u),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Ve(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,u),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Ve(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,u));break;case"XZY":this._z=Math.asin(-Ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,u),this._y=0);break;default:Ce("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return _f.makeRotationFromQuaternion(e),this.setFromRotationMatrix(_f,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return vf.setFromEuler(this),this.setFromQuaternion(vf,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};yi.DEFAULT_ORDER="XYZ";var or=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},k_=0,yf=new P,zs=new rn,ui=new qe,ra=new P,Or=new P,z_=new P,G_=new rn,xf=new P(1,0,0),bf=new P(0,1,0),Sf=new P(0,0,1),Mf={type:"added"},V_={type:"removed"},Gs={type:"childadded",child:null},hh={type:"childremoved",child:null},Vt=class n extends $n{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:k_++}),this.uuid=mr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new P,t=new yi,i=new rn,s=new P(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new qe},normalMatrix:{value:new Ne}}),this.matrix=new qe,this.matrixWorld=new qe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new or,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return zs.setFromAxisAngle(e,t),this.quaternion.multiply(zs),this}rotateOnWorldAxis(e,t){return zs.setFromAxisAngle(e,t),this.quaternion.premultiply(zs),this}rotateX(e){return this.rotateOnAxis(xf,e)}rotateY(e){return this.rotateOnAxis(bf,e)}rotateZ(e){return this.rotateOnAxis(Sf,e)}translateOnAxis(e,t){return yf.copy(e).applyQuaternion(this.quaternion),this.position.add(yf.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(xf,e)}translateY(e){return this.translateOnAxis(bf,e)}translateZ(e){return this.translateOnAxis(Sf,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ui.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ra.copy(e):ra.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Or.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ui.lookAt(Or,ra,this.up):ui.lookAt(ra,Or,this.up),this.quaternion.setFromRotationMatrix(ui),s&&(ui.extractRotation(s.matrixWorld),zs.setFromRotationMatrix(ui),this.quaternion.premultiply(zs.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(De("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Mf),Gs.child=e,this.dispatchEvent(Gs),Gs.child=null):De("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(V_),hh.child=e,this.dispatchEvent(hh),hh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ui.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ui.multiply(e.parent.matrixWorld)),e.applyMatrix4(ui),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Mf),Gs.child=e,this.dispatchEvent(Gs),Gs.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Or,e,z_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Or,G_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(e.shapes,f)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),f=o(e.shapes),d=o(e.skeletons),u=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),d.length>0&&(i.skeletons=d),u.length>0&&(i.animations=u),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vt.DEFAULT_UP=new P(0,1,0);Vt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var pt=class extends Vt{constructor(){super(),this.isGroup=!0,this.type="Group"}},H_={type:"move"},ar=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,i),g=this._getHandJoint(l,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),u=.02,_=.005;l.inputState.pinching&&d>u+_?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=u-_&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(H_)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new pt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Lp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fi={h:0,s:0,l:0},oa={h:0,s:0,l:0};function uh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Oe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Rn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ke.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Ke.workingColorSpace){return this.r=e,this.g=t,this.b=i,Ke.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Ke.workingColorSpace){if(e=hu(e,1),t=Ve(t,0,1),i=Ve(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=uh(o,r,e+1/3),this.g=uh(o,r,e),this.b=uh(o,r,e-1/3)}return Ke.colorSpaceToWorking(this,s),this}setStyle(e,t=Rn){function i(r){r!==void 0&&parseFloat(r)<1&&Ce("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ce("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ce("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Rn){let i=Lp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ce("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=_i(e.r),this.g=_i(e.g),this.b=_i(e.b),this}copyLinearToSRGB(e){return this.r=Qs(e.r),this.g=Qs(e.g),this.b=Qs(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Rn){return Ke.workingToColorSpace(cn.copy(this),e),Math.round(Ve(cn.r*255,0,255))*65536+Math.round(Ve(cn.g*255,0,255))*256+Math.round(Ve(cn.b*255,0,255))}getHexString(e=Rn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ke.workingColorSpace){Ke.workingToColorSpace(cn.copy(this),t);let i=cn.r,s=cn.g,r=cn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let f=o-a;switch(l=h<=.5?f/(o+a):f/(2-o-a),o){case i:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-i)/f+2;break;case r:c=(i-s)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=Ke.workingColorSpace){return Ke.workingToColorSpace(cn.copy(this),t),e.r=cn.r,e.g=cn.g,e.b=cn.b,e}getStyle(e=Rn){Ke.workingToColorSpace(cn.copy(this),e);let t=cn.r,i=cn.g,s=cn.b;return e!==Rn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Fi),this.setHSL(Fi.h+e,Fi.s+t,Fi.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Fi),e.getHSL(oa);let i=Wr(Fi.h,oa.h,t),s=Wr(Fi.s,oa.s,t),r=Wr(Fi.l,oa.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},cn=new Oe;Oe.NAMES=Lp;var Kr=class extends Vt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new yi,this.environmentIntensity=1,this.environmentRotation=new yi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Yn=new P,di=new P,dh=new P,fi=new P,Vs=new P,Hs=new P,wf=new P,fh=new P,ph=new P,mh=new P,gh=new bt,_h=new bt,vh=new bt,gi=class n{constructor(e=new P,t=new P,i=new P){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Yn.subVectors(e,t),s.cross(Yn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Yn.subVectors(s,t),di.subVectors(i,t),dh.subVectors(e,t);let o=Yn.dot(Yn),a=Yn.dot(di),c=Yn.dot(dh),l=di.dot(di),h=di.dot(dh),f=o*l-a*a;if(f===0)return r.set(0,0,0),null;let d=1/f,u=(l*c-a*h)*d,_=(o*h-a*c)*d;return r.set(1-u-_,_,u)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,fi)===null?!1:fi.x>=0&&fi.y>=0&&fi.x+fi.y<=1}static getInterpolation(e,t,i,s,r,o,a,c){return this.getBarycoord(e,t,i,s,fi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,fi.x),c.addScaledVector(o,fi.y),c.addScaledVector(a,fi.z),c)}static getInterpolatedAttribute(e,t,i,s,r,o){return gh.setScalar(0),_h.setScalar(0),vh.setScalar(0),gh.fromBufferAttribute(e,t),_h.fromBufferAttribute(e,i),vh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(gh,r.x),o.addScaledVector(_h,r.y),o.addScaledVector(vh,r.z),o}static isFrontFacing(e,t,i,s){return Yn.subVectors(i,t),di.subVectors(e,t),Yn.cross(di).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yn.subVectors(this.c,this.b),di.subVectors(this.a,this.b),Yn.cross(di).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Vs.subVectors(s,i),Hs.subVectors(r,i),fh.subVectors(e,i);let c=Vs.dot(fh),l=Hs.dot(fh);if(c<=0&&l<=0)return t.copy(i);ph.subVectors(e,s);let h=Vs.dot(ph),f=Hs.dot(ph);if(h>=0&&f<=h)return t.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(i).addScaledVector(Vs,o);mh.subVectors(e,r);let u=Vs.dot(mh),_=Hs.dot(mh);if(_>=0&&u<=_)return t.copy(r);let b=u*l-c*_;if(b<=0&&l>=0&&_<=0)return a=l/(l-_),t.copy(i).addScaledVector(Hs,a);let m=h*_-u*f;if(m<=0&&f-h>=0&&u-_>=0)return wf.subVectors(r,s),a=(f-h)/(f-h+(u-_)),t.copy(s).addScaledVector(wf,a);let g=1/(m+b+d);return o=b*g,a=d*g,t.copy(i).addScaledVector(Vs,o).addScaledVector(Hs,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ut=class{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Zn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Zn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Zn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zn):Zn.fromBufferAttribute(r,o),Zn.applyMatrix4(e.matrixWorld),this.expandByPoint(Zn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),aa.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),aa.copy(i.boundingBox)),aa.applyMatrix4(e.matrixWorld),this.union(aa)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zn),Zn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Fr),la.subVectors(this.max,Fr),Ws.subVectors(e.a,Fr),Xs.subVectors(e.b,Fr),qs.subVectors(e.c,Fr),Bi.subVectors(Xs,Ws),ki.subVectors(qs,Xs),ps.subVectors(Ws,qs);let t=[0,-Bi.z,Bi.y,0,-ki.z,ki.y,0,-ps.z,ps.y,Bi.z,0,-Bi.x,ki.z,0,-ki.x,ps.z,0,-ps.x,-Bi.y,Bi.x,0,-ki.y,ki.x,0,-ps.y,ps.x,0];return!yh(t,Ws,Xs,qs,la)||(t=[1,0,0,0,1,0,0,0,1],!yh(t,Ws,Xs,qs,la))?!1:(ca.crossVectors(Bi,ki),t=[ca.x,ca.y,ca.z],yh(t,Ws,Xs,qs,la))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(pi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),pi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),pi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),pi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),pi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),pi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),pi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),pi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(pi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},pi=[new P,new P,new P,new P,new P,new P,new P,new P],Zn=new P,aa=new Ut,Ws=new P,Xs=new P,qs=new P,Bi=new P,ki=new P,ps=new P,Fr=new P,la=new P,ca=new P,ms=new P;function yh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ms.fromArray(n,r);let a=s.x*Math.abs(ms.x)+s.y*Math.abs(ms.y)+s.z*Math.abs(ms.z),c=e.dot(ms),l=t.dot(ms),h=i.dot(ms);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Nt=new P,ha=new ye,W_=0,Pn=class extends $n{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:W_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Tp,this.updateRanges=[],this.gpuType=Hn,this.version=0,this._normalizationScale=e!==void 0?du(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ha.fromBufferAttribute(this,t),ha.applyMatrix3(e),this.setXY(t,ha.x,ha.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix3(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix4(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyNormalMatrix(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.transformDirection(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Pp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ip(e,this.array)}};var Qr=class extends Pn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var eo=class extends Pn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Rt=class extends Pn{constructor(e,t,i){super(new Float32Array(e),t,i)}},X_=new Ut,Br=new P,xh=new P,xi=class{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):X_.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Br.subVectors(e,this.center);let t=Br.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Br,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(xh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Br.copy(e.center).add(xh)),this.expandByPoint(Br.copy(e.center).sub(xh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},q_=0,Bn=new qe,bh=new Vt,Ys=new P,An=new Ut,kr=new Ut,Kt=new P,Sn=class n extends $n{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:q_++}),this.uuid=mr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(__(e)?eo:Qr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ne().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Bn.makeRotationFromQuaternion(e),this.applyMatrix4(Bn),this}rotateX(e){return Bn.makeRotationX(e),this.applyMatrix4(Bn),this}rotateY(e){return Bn.makeRotationY(e),this.applyMatrix4(Bn),this}rotateZ(e){return Bn.makeRotationZ(e),this.applyMatrix4(Bn),this}translate(e,t,i){return Bn.makeTranslation(e,t,i),this.applyMatrix4(Bn),this}scale(e,t,i){return Bn.makeScale(e,t,i),this.applyMatrix4(Bn),this}lookAt(e){return bh.lookAt(e),bh.updateMatrix(),this.applyMatrix4(bh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ys).negate(),this.translate(Ys.x,Ys.y,Ys.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Rt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ce("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ut);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];An.setFromBufferAttribute(r),this.morphTargetsRelative?(Kt.addVectors(this.boundingBox.min,An.min),this.boundingBox.expandByPoint(Kt),Kt.addVectors(this.boundingBox.max,An.max),this.boundingBox.expandByPoint(Kt)):(this.boundingBox.expandByPoint(An.min),this.boundingBox.expandByPoint(An.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&De('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){let i=this.boundingSphere.center;if(An.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];kr.setFromBufferAttribute(a),this.morphTargetsRelative?(Kt.addVectors(An.min,kr.min),An.expandByPoint(Kt),Kt.addVectors(An.max,kr.max),An.expandByPoint(Kt)):(An.expandByPoint(kr.min),An.expandByPoint(kr.max))}An.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Kt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Kt));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Kt.fromBufferAttribute(a,l),c&&(Ys.fromBufferAttribute(e,l),Kt.add(Ys)),s=Math.max(s,i.distanceToSquared(Kt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&De('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){De("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Pn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new P,c[B]=new P;let h=new P,f=new P,d=new P,u=new ye,_=new ye,b=new ye,m=new P,g=new P;function S(B,N,O){l[B]=l[N]=l[O]=1,h.fromBufferAttribute(i,B),f.fromBufferAttribute(i,N),d.fromBufferAttribute(i,O),u.fromBufferAttribute(r,B),_.fromBufferAttribute(r,N),b.fromBufferAttribute(r,O),f.sub(h),d.sub(h),_.sub(u),b.sub(u);let G=1/(_.x*b.y-b.x*_.y);isFinite(G)&&(m.copy(f).multiplyScalar(b.y).addScaledVector(d,-_.y).multiplyScalar(G),g.copy(d).multiplyScalar(_.x).addScaledVector(f,-b.x).multiplyScalar(G),a[B].add(m),a[N].add(m),a[O].add(m),c[B].add(g),c[N].add(g),c[O].add(g))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let B=0,N=E.length;B<N;++B){let O=E[B],G=O.start,W=O.count;for(let D=G,Y=G+W;D<Y;D+=3)S(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let M=new P,C=new P,R=new P,v=new P;function w(B){R.fromBufferAttribute(s,B),v.copy(R);let N=a[B];M.copy(N),M.sub(R.multiplyScalar(R.dot(N))).normalize(),C.crossVectors(v,N);let G=C.dot(c[B])<0?-1:1;o.setXYZW(B,M.x,M.y,M.z,G)}for(let B=0,N=i.count;B<N;++B)l[B]&&w(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Pn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,u=i.count;d<u;d++)i.setXYZ(d,0,0,0);let s=new P,r=new P,o=new P,a=new P,c=new P,l=new P,h=new P,f=new P;if(e)for(let d=0,u=e.count;d<u;d+=3){let _=e.getX(d+0),b=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,m),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),a.fromBufferAttribute(i,_),c.fromBufferAttribute(i,b),l.fromBufferAttribute(i,m),a.add(h),c.add(h),l.add(h),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(b,c.x,c.y,c.z),i.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,u=t.count;d<u;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Kt.fromBufferAttribute(e,t),Kt.normalize(),e.setXYZ(t,Kt.x,Kt.y,Kt.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,f=a.normalized,d=new l.constructor(c.length*h),u=0,_=0;for(let b=0,m=c.length;b<m;b++){a.isInterleavedBufferAttribute?u=c[b]*a.data.stride+a.offset:u=c[b]*h;for(let g=0;g<h;g++)d[_++]=l[u++]}return new Pn(d,h,f)}if(this.index===null)return Ce("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,i);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,f=l.length;h<f;h++){let d=l[h],u=e(d,i);c.push(u)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let c in i){let l=i[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let u=l[f];h.push(u.toJSON(e.data))}h.length>0&&(s[c]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(t))}let r=e.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,u=f.length;d<u;d++)h.push(f[d].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let f=o[l];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Sh=new P,Y_=new P,Z_=new Ne,Cn=class{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Sh.subVectors(i,t).cross(Y_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Sh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Z_.getNormalMatrix(e),s=this.coplanarPoint(Sh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},$_=0,bi=class extends $n{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:$_++}),this.uuid=mr(),this.name="",this.type="Material",this.blending=dr,this.side=Ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hh,this.blendDst=Wh,this.blendEquation=Ss,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Oe(0,0,0),this.blendAlpha=0,this.depthFunc=er,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=yp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ia,this.stencilZFail=Ia,this.stencilZPass=Ia,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ce(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ce(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Oe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Cn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ye().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ye().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var mi=new P,Mh=new P,ua=new P,da=new P,Gi=class{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,mi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=mi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(mi.copy(this.origin).addScaledVector(this.direction,t),mi.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Mh.copy(e).add(t).multiplyScalar(.5),ua.copy(t).sub(e).normalize(),da.copy(this.origin).sub(Mh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(ua),a=da.dot(this.direction),c=-da.dot(ua),l=da.lengthSq(),h=Math.abs(1-o*o),f,d,u,_;if(h>0)if(f=o*c-a,d=o*a-c,_=r*h,f>=0)if(d>=-_)if(d<=_){let b=1/h;f*=b,d*=b,u=f*(f+o*d+2*a)+d*(o*f+d+2*c)+l}else d=r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*c)+l;else d<=-_?(f=Math.max(0,-(-o*r+a)),d=f>0?-r:Math.min(Math.max(-r,-c),r),u=-f*f+d*(d+2*c)+l):d<=_?(f=0,d=Math.min(Math.max(-r,-c),r),u=d*(d+2*c)+l):(f=Math.max(0,-(o*r+a)),d=f>0?r:Math.min(Math.max(-r,-c),r),u=-f*f+d*(d+2*c)+l);else d=o>0?-r:r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Mh).addScaledVector(ua,d),u}intersectSphere(e,t){if(e.radius<0)return null;mi.subVectors(e.center,this.origin);let i=mi.dot(this.direction),s=mi.dot(mi)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(i=(e.min.x-d.x)*l,s=(e.max.x-d.x)*l):(i=(e.max.x-d.x)*l,s=(e.min.x-d.x)*l),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-d.z)*f,c=(e.max.z-d.z)*f):(a=(e.max.z-d.z)*f,c=(e.min.z-d.z)*f),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,mi)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,f=e.x-o.x,d=e.y-o.y,u=e.z-o.z,_=t.x-o.x,b=t.y-o.y,m=t.z-o.z,g=i.x-o.x,S=i.y-o.y,E=i.z-o.z,M=Math.abs(c),C=Math.abs(l),R=Math.abs(h),v,w,B,N,O,G,W,D,Y,K,H,ie;if(M>=C&&M>=R?(B=c,G=f,Y=_,ie=g,c>=0?(v=l,w=h,N=d,O=u,W=b,D=m,K=S,H=E):(v=h,w=l,N=u,O=d,W=m,D=b,K=E,H=S)):C>=R?(B=l,G=d,Y=b,ie=S,l>=0?(v=h,w=c,N=u,O=f,W=m,D=_,K=E,H=g):(v=c,w=h,N=f,O=u,W=_,D=m,K=g,H=E)):(B=h,G=u,Y=m,ie=E,h>=0?(v=c,w=l,N=f,O=d,W=_,D=b,K=g,H=S):(v=l,w=c,N=d,O=f,W=b,D=_,K=S,H=g)),B===0)return null;let q=v/B,ee=w/B,te=1/B,Te=N-q*G,Fe=O-ee*G,j=W-q*Y,ge=D-ee*Y,be=K-q*ie,Pe=H-ee*ie,_e=be*ge-Pe*j,ke=Te*Pe-Fe*be,Pt=j*Fe-ge*Te;if(s){if(_e<0||ke<0||Pt<0)return null}else if((_e<0||ke<0||Pt<0)&&(_e>0||ke>0||Pt>0))return null;let Le=_e+ke+Pt;if(Le===0)return null;let ot=te*(_e*G+ke*Y+Pt*ie);return(Le>0?ot<0:ot>0)?null:this.at(ot/Le,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},vs=class extends bi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new yi,this.combine=gl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Tf=new qe,gs=new Gi,fa=new xi,Ef=new P,pa=new P,ma=new P,ga=new P,wh=new P,_a=new P,Af=new P,va=new P,mt=class extends Vt{constructor(e=new Sn,t=new vs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){_a.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],f=r[c];h!==0&&(wh.fromBufferAttribute(f,e),o?_a.addScaledVector(wh,h):_a.addScaledVector(wh.sub(t),h))}t.add(_a)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),fa.copy(i.boundingSphere),fa.applyMatrix4(r),gs.copy(e.ray).recast(e.near),!(fa.containsPoint(gs.origin)===!1&&(gs.intersectSphere(fa,Ef)===null||gs.origin.distanceToSquared(Ef)>(e.far-e.near)**2))&&(Tf.copy(r).invert(),gs.copy(e.ray).applyMatrix4(Tf),!(i.boundingBox!==null&&gs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,gs)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,u=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,b=d.length;_<b;_++){let m=d[_],g=o[m.materialIndex],S=Math.max(m.start,u.start),E=Math.min(a.count,Math.min(m.start+m.count,u.start+u.count));for(let M=S,C=E;M<C;M+=3){let R=a.getX(M),v=a.getX(M+1),w=a.getX(M+2);s=ya(this,g,e,i,l,h,f,R,v,w),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,u.start),b=Math.min(a.count,u.start+u.count);for(let m=_,g=b;m<g;m+=3){let S=a.getX(m),E=a.getX(m+1),M=a.getX(m+2);s=ya(this,o,e,i,l,h,f,S,E,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let _=0,b=d.length;_<b;_++){let m=d[_],g=o[m.materialIndex],S=Math.max(m.start,u.start),E=Math.min(c.count,Math.min(m.start+m.count,u.start+u.count));for(let M=S,C=E;M<C;M+=3){let R=M,v=M+1,w=M+2;s=ya(this,g,e,i,l,h,f,R,v,w),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,u.start),b=Math.min(c.count,u.start+u.count);for(let m=_,g=b;m<g;m+=3){let S=m,E=m+1,M=m+2;s=ya(this,o,e,i,l,h,f,S,E,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function j_(n,e,t,i,s,r,o,a){let c;if(e.side===vn?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,e.side===Ji,a),c===null)return null;va.copy(a),va.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(va);return l<t.near||l>t.far?null:{distance:l,point:va.clone(),object:n}}function ya(n,e,t,i,s,r,o,a,c,l){n.getVertexPosition(a,pa),n.getVertexPosition(c,ma),n.getVertexPosition(l,ga);let h=j_(n,e,t,i,pa,ma,ga,Af);if(h){let f=new P;gi.getBarycoord(Af,pa,ma,ga,f),s&&(h.uv=gi.getInterpolatedAttribute(s,a,c,l,f,new ye)),r&&(h.uv1=gi.getInterpolatedAttribute(r,a,c,l,f,new ye)),o&&(h.normal=gi.getInterpolatedAttribute(o,a,c,l,f,new P),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new P,materialIndex:0};gi.getNormal(pa,ma,ga,d.normal),h.face=d,h.barycoord=f}return h}var to=class extends _n{constructor(e=null,t=1,i=1,s,r,o,a,c,l=Qt,h=Qt,f,d){super(null,o,a,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var no=class extends Pn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Zs=new qe,Rf=new qe,xa=[],Cf=new Ut,J_=new qe,zr=new mt,Gr=new xi,io=class extends mt{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new no(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,J_)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ut),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zs),Cf.copy(e.boundingBox).applyMatrix4(Zs),this.boundingBox.union(Cf)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new xi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zs),Gr.copy(e.boundingSphere).applyMatrix4(Zs),this.boundingSphere.union(Gr)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(zr.geometry=this.geometry,zr.material=this.material,zr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Gr.copy(this.boundingSphere),Gr.applyMatrix4(i),e.ray.intersectsSphere(Gr)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Zs),Rf.multiplyMatrices(i,Zs),zr.matrixWorld=Rf,zr.raycast(e,xa);for(let o=0,a=xa.length;o<a;o++){let c=xa[o];c.instanceId=r,c.object=this,t.push(c)}xa.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new no(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new to(new Float32Array(s*this.count),s,this.count,Ml,Hn));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*e;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},_s=new xi,K_=new ye(.5,.5),ba=new P,Vi=class{constructor(e=new Cn,t=new Cn,i=new Cn,s=new Cn,r=new Cn,o=new Cn){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=kn,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],u=r[7],_=r[8],b=r[9],m=r[10],g=r[11],S=r[12],E=r[13],M=r[14],C=r[15];if(s[0].setComponents(l-o,u-h,g-_,C-S).normalize(),s[1].setComponents(l+o,u+h,g+_,C+S).normalize(),s[2].setComponents(l+a,u+f,g+b,C+E).normalize(),s[3].setComponents(l-a,u-f,g-b,C-E).normalize(),i)s[4].setComponents(c,d,m,M).normalize(),s[5].setComponents(l-c,u-d,g-m,C-M).normalize();else if(s[4].setComponents(l-c,u-d,g-m,C-M).normalize(),t===kn)s[5].setComponents(l+c,u+d,g+m,C+M).normalize();else if(t===nr)s[5].setComponents(c,d,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),_s.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),_s.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(_s)}intersectsSprite(e){_s.center.set(0,0,0);let t=K_.distanceTo(e.center);return _s.radius=.7071067811865476+t,_s.applyMatrix4(e.matrixWorld),this.intersectsSphere(_s)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(ba.x=s.normal.x>0?e.max.x:e.min.x,ba.y=s.normal.y>0?e.max.y:e.min.y,ba.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ba)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Pf=new qe,Wa=class n{constructor(){this.coordinateSystem=kn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Pf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Vi),i[s].setFromProjectionMatrix(Pf,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Vi),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Si=class extends bi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Xa=new P,qa=new P,If=new qe,Vr=new Gi,Sa=new xi,Th=new P,Lf=new P,Ya=class extends Vt{constructor(e=new Sn,t=new Si){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Xa.fromBufferAttribute(t,s-1),qa.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Xa.distanceTo(qa);e.setAttribute("lineDistance",new Rt(i,1))}else Ce("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Sa.copy(i.boundingSphere),Sa.applyMatrix4(s),Sa.radius+=r,e.ray.intersectsSphere(Sa)===!1)return;If.copy(s).invert(),Vr.copy(e.ray).applyMatrix4(If);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let u=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let b=u,m=_-1;b<m;b+=l){let g=h.getX(b),S=h.getX(b+1),E=Ma(this,e,Vr,c,g,S,b);E&&t.push(E)}if(this.isLineLoop){let b=h.getX(_-1),m=h.getX(u),g=Ma(this,e,Vr,c,b,m,_-1);g&&t.push(g)}}else{let u=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let b=u,m=_-1;b<m;b+=l){let g=Ma(this,e,Vr,c,b,b+1,b);g&&t.push(g)}if(this.isLineLoop){let b=Ma(this,e,Vr,c,_-1,u,_-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ma(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Xa.fromBufferAttribute(a,s),qa.fromBufferAttribute(a,r),t.distanceSqToSegment(Xa,qa,Th,Lf)>i)return;Th.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Th);if(!(l<e.near||l>e.far))return{distance:l,point:Lf.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Df=new P,Nf=new P,Hi=class extends Ya{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Df.fromBufferAttribute(t,s),Nf.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Df.distanceTo(Nf);e.setAttribute("lineDistance",new Rt(i,1))}else Ce("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var so=class extends _n{constructor(e=[],t=Ms,i,s,r,o,a,c,l,h){super(e,t,i,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ro=class extends _n{constructor(e,t,i,s,r,o,a,c,l){super(e,t,i,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Mi=class extends _n{constructor(e,t,i=jn,s,r,o,a=Qt,c=Qt,l,h=vi,f=1){if(h!==vi&&h!==Ti)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:f};super(d,s,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new rr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},oo=class extends Mi{constructor(e,t=jn,i=Ms,s,r,o=Qt,a=Qt,c,l=vi){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ao=class extends _n{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Wi=class n extends Sn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],f=[],d=0,u=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Rt(l,3)),this.setAttribute("normal",new Rt(h,3)),this.setAttribute("uv",new Rt(f,2));function _(b,m,g,S,E,M,C,R,v,w,B){let N=M/v,O=C/w,G=M/2,W=C/2,D=R/2,Y=v+1,K=w+1,H=0,ie=0,q=new P;for(let ee=0;ee<K;ee++){let te=ee*O-W;for(let Te=0;Te<Y;Te++){let Fe=Te*N-G;q[b]=Fe*S,q[m]=te*E,q[g]=D,l.push(q.x,q.y,q.z),q[b]=0,q[m]=0,q[g]=R>0?1:-1,h.push(q.x,q.y,q.z),f.push(Te/v),f.push(1-ee/w),H+=1}}for(let ee=0;ee<w;ee++)for(let te=0;te<v;te++){let Te=d+te+Y*ee,Fe=d+te+Y*(ee+1),j=d+(te+1)+Y*(ee+1),ge=d+(te+1)+Y*ee;c.push(Te,Fe,ge),c.push(Fe,j,ge),ie+=6}a.addGroup(u,ie,B),u+=ie,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var wa=new P,Ta=new P,Eh=new P,Ea=new gi,lo=class extends Sn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Ks*t),o=e.getIndex(),a=e.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,u=[];for(let _=0;_<c;_+=3){o?(l[0]=o.getX(_),l[1]=o.getX(_+1),l[2]=o.getX(_+2)):(l[0]=_,l[1]=_+1,l[2]=_+2);let{a:b,b:m,c:g}=Ea;if(b.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),Ea.getNormal(Eh),f[0]=`${Math.round(b.x*s)},${Math.round(b.y*s)},${Math.round(b.z*s)}`,f[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,f[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let S=0;S<3;S++){let E=(S+1)%3,M=f[S],C=f[E],R=Ea[h[S]],v=Ea[h[E]],w=`${M}_${C}`,B=`${C}_${M}`,N=d.get(B);N?(Eh.dot(N.normal)<=r&&(u.push(R.x,R.y,R.z),u.push(v.x,v.y,v.z)),d.set(B,null)):d.has(w)||d.set(w,{index0:l[S],index1:l[E],normal:Eh.clone()})}}for(let _ of d.values())if(_){let{index0:b,index1:m}=_;wa.fromBufferAttribute(a,b),Ta.fromBufferAttribute(a,m),u.push(wa.x,wa.y,wa.z),u.push(Ta.x,Ta.y,Ta.z)}this.setAttribute("position",new Rt(u,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},zn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ce("Curve: .getPoint() not implemented.")}getPointAt(e,t){let i=this.getUtoTmapping(e);return this.getPoint(i,t)}getPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return t}getSpacedPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPointAt(i/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],i,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)i=this.getPoint(o/e),r+=i.distanceTo(s),t.push(r),s=i;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let i=this.getLengths(),s=0,r=i.length,o;t?o=t:o=e*i[r-1];let a=0,c=r-1,l;for(;a<=c;)if(s=Math.floor(a+(c-a)/2),l=i[s]-o,l<0)a=s+1;else if(l>0)c=s-1;else{c=s;break}if(s=c,i[s]===o)return s/(r-1);let h=i[s],d=i[s+1]-h,u=(o-h)/d;return(s+u)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),c=t||(o.isVector2?new ye:new P);return c.copy(a).sub(o).normalize(),c}getTangentAt(e,t){let i=this.getUtoTmapping(e);return this.getTangent(i,t)}computeFrenetFrames(e,t=!1){let i=new P,s=[],r=[],o=[],a=new P,c=new qe;for(let u=0;u<=e;u++){let _=u/e;s[u]=this.getTangentAt(_,new P)}r[0]=new P,o[0]=new P;let l=Number.MAX_VALUE,h=Math.abs(s[0].x),f=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=l&&(l=h,i.set(1,0,0)),f<=l&&(l=f,i.set(0,1,0)),d<=l&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let u=1;u<=e;u++){if(r[u]=r[u-1].clone(),o[u]=o[u-1].clone(),a.crossVectors(s[u-1],s[u]),a.length()>Number.EPSILON){a.normalize();let _=Math.acos(Ve(s[u-1].dot(s[u]),-1,1));r[u].applyMatrix4(c.makeRotationAxis(a,_))}o[u].crossVectors(s[u],r[u])}if(t===!0){let u=Math.acos(Ve(r[0].dot(r[e]),-1,1));u/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(u=-u);for(let _=1;_<=e;_++)r[_].applyMatrix4(c.makeRotationAxis(s[_],u*_)),o[_].crossVectors(s[_],r[_])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},co=class extends zn{constructor(e=0,t=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,c=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=c}getPoint(e,t=new ye){let i=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,c=this.aX+this.xRadius*Math.cos(a),l=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),f=Math.sin(this.aRotation),d=c-this.aX,u=l-this.aY;c=d*h-u*f+this.aX,l=d*f+u*h+this.aY}return i.set(c,l)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Za=class extends co{constructor(e,t,i,s,r,o){super(e,t,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function fu(){let n=0,e=0,t=0,i=0;function s(r,o,a,c){n=r,e=a,t=-3*r+3*o-2*a-c,i=2*r-2*o+a+c}return{initCatmullRom:function(r,o,a,c,l){s(o,a,l*(a-r),l*(c-o))},initNonuniformCatmullRom:function(r,o,a,c,l,h,f){let d=(o-r)/l-(a-r)/(l+h)+(a-o)/h,u=(a-o)/h-(c-o)/(h+f)+(c-a)/f;d*=h,u*=h,s(o,a,d,u)},calc:function(r){let o=r*r,a=o*r;return n+e*r+t*o+i*a}}}var Uf=new P,Of=new P,Ah=new fu,Rh=new fu,Ch=new fu,lr=class extends zn{constructor(e=[],t=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=i,this.tension=s}getPoint(e,t=new P){let i=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),c=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:c===0&&a===r-1&&(a=r-2,c=1);let l,h;this.closed||a>0?l=s[(a-1)%r]:(Of.subVectors(s[0],s[1]).add(s[0]),l=Of);let f=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Uf.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Uf),this.curveType==="centripetal"||this.curveType==="chordal"){let u=this.curveType==="chordal"?.5:.25,_=Math.pow(l.distanceToSquared(f),u),b=Math.pow(f.distanceToSquared(d),u),m=Math.pow(d.distanceToSquared(h),u);b<1e-4&&(b=1),_<1e-4&&(_=b),m<1e-4&&(m=b),Ah.initNonuniformCatmullRom(l.x,f.x,d.x,h.x,_,b,m),Rh.initNonuniformCatmullRom(l.y,f.y,d.y,h.y,_,b,m),Ch.initNonuniformCatmullRom(l.z,f.z,d.z,h.z,_,b,m)}else this.curveType==="catmullrom"&&(Ah.initCatmullRom(l.x,f.x,d.x,h.x,this.tension),Rh.initCatmullRom(l.y,f.y,d.y,h.y,this.tension),Ch.initCatmullRom(l.z,f.z,d.z,h.z,this.tension));return i.set(Ah.calc(c),Rh.calc(c),Ch.calc(c)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(new P().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Ff(n,e,t,i,s){let r=(i-e)*.5,o=(s-t)*.5,a=n*n,c=n*a;return(2*t-2*i+r+o)*c+(-3*t+3*i-2*r-o)*a+r*n+t}function Q_(n,e){let t=1-n;return t*t*e}function ev(n,e){return 2*(1-n)*n*e}function tv(n,e){return n*n*e}function Xr(n,e,t,i){return Q_(n,e)+ev(n,t)+tv(n,i)}function nv(n,e){let t=1-n;return t*t*t*e}function iv(n,e){let t=1-n;return 3*t*t*n*e}function sv(n,e){return 3*(1-n)*n*n*e}function rv(n,e){return n*n*n*e}function qr(n,e,t,i,s){return nv(n,e)+iv(n,t)+sv(n,i)+rv(n,s)}var $a=class extends zn{constructor(e=new ye,t=new ye,i=new ye,s=new ye){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=i,this.v3=s}getPoint(e,t=new ye){let i=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(qr(e,s.x,r.x,o.x,a.x),qr(e,s.y,r.y,o.y,a.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ja=class extends zn{constructor(e=new P,t=new P,i=new P,s=new P){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=i,this.v3=s}getPoint(e,t=new P){let i=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(qr(e,s.x,r.x,o.x,a.x),qr(e,s.y,r.y,o.y,a.y),qr(e,s.z,r.z,o.z,a.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Ja=class extends zn{constructor(e=new ye,t=new ye){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new ye){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new ye){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ka=class extends zn{constructor(e=new P,t=new P){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new P){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new P){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Qa=class extends zn{constructor(e=new ye,t=new ye,i=new ye){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new ye){let i=t,s=this.v0,r=this.v1,o=this.v2;return i.set(Xr(e,s.x,r.x,o.x),Xr(e,s.y,r.y,o.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ho=class extends zn{constructor(e=new P,t=new P,i=new P){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new P){let i=t,s=this.v0,r=this.v1,o=this.v2;return i.set(Xr(e,s.x,r.x,o.x),Xr(e,s.y,r.y,o.y),Xr(e,s.z,r.z,o.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},el=class extends zn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new ye){let i=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,c=s[o===0?o:o-1],l=s[o],h=s[o>s.length-2?s.length-1:o+1],f=s[o>s.length-3?s.length-1:o+2];return i.set(Ff(a,c.x,l.x,h.x,f.x),Ff(a,c.y,l.y,h.y,f.y)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(new ye().fromArray(s))}return this}},ov=Object.freeze({__proto__:null,ArcCurve:Za,CatmullRomCurve3:lr,CubicBezierCurve:$a,CubicBezierCurve3:ja,EllipseCurve:co,LineCurve:Ja,LineCurve3:Ka,QuadraticBezierCurve:Qa,QuadraticBezierCurve3:ho,SplineCurve:el});var ys=class n extends Sn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),c=Math.floor(s),l=a+1,h=c+1,f=e/a,d=t/c,u=[],_=[],b=[],m=[];for(let g=0;g<h;g++){let S=g*d-o;for(let E=0;E<l;E++){let M=E*f-r;_.push(M,-S,0),b.push(0,0,1),m.push(E/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let S=0;S<a;S++){let E=S+l*g,M=S+l*(g+1),C=S+1+l*(g+1),R=S+1+l*g;u.push(E,M,R),u.push(M,C,R)}this.setIndex(u),this.setAttribute("position",new Rt(_,3)),this.setAttribute("normal",new Rt(b,3)),this.setAttribute("uv",new Rt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}},uo=class n extends Sn{constructor(e=.5,t=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],c=[],l=[],h=[],f=e,d=(t-e)/s,u=new P,_=new ye;for(let b=0;b<=s;b++){for(let m=0;m<=i;m++){let g=r+m/i*o;u.x=f*Math.cos(g),u.y=f*Math.sin(g),c.push(u.x,u.y,u.z),l.push(0,0,1),_.x=(u.x/t+1)/2,_.y=(u.y/t+1)/2,h.push(_.x,_.y)}f+=d}for(let b=0;b<s;b++){let m=b*(i+1);for(let g=0;g<i;g++){let S=g+m,E=S,M=S+i+1,C=S+i+2,R=S+1;a.push(E,M,R),a.push(M,C,R)}}this.setIndex(a),this.setAttribute("position",new Rt(c,3)),this.setAttribute("normal",new Rt(l,3)),this.setAttribute("uv",new Rt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};var fo=class n extends Sn{constructor(e=new ho(new P(-1,-1,0),new P(-1,1,0),new P(1,1,0)),t=64,i=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:i,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new P,c=new P,l=new ye,h=new P,f=[],d=[],u=[],_=[];b(),this.setIndex(_),this.setAttribute("position",new Rt(f,3)),this.setAttribute("normal",new Rt(d,3)),this.setAttribute("uv",new Rt(u,2));function b(){for(let E=0;E<t;E++)m(E);m(r===!1?t:0),S(),g()}function m(E){h=e.getPointAt(E/t,h);let M=o.normals[E],C=o.binormals[E];for(let R=0;R<=s;R++){let v=R/s*Math.PI*2,w=Math.sin(v),B=-Math.cos(v);c.x=B*M.x+w*C.x,c.y=B*M.y+w*C.y,c.z=B*M.z+w*C.z,c.normalize(),d.push(c.x,c.y,c.z),a.x=h.x+i*c.x,a.y=h.y+i*c.y,a.z=h.z+i*c.z,f.push(a.x,a.y,a.z)}}function g(){for(let E=1;E<=t;E++)for(let M=1;M<=s;M++){let C=(s+1)*(E-1)+(M-1),R=(s+1)*E+(M-1),v=(s+1)*E+M,w=(s+1)*(E-1)+M;_.push(C,R,w),_.push(R,v,w)}}function S(){for(let E=0;E<=t;E++)for(let M=0;M<=s;M++)l.x=E/t,l.y=M/s,u.push(l.x,l.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new n(new ov[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function Ts(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Bf(s))s.isRenderTargetTexture?(Ce("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Bf(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function un(n){let e={};for(let t=0;t<n.length;t++){let i=Ts(n[t]);for(let s in i)e[s]=i[s]}return e}function Bf(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function av(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function pu(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ke.workingColorSpace}var Dp={clone:Ts,merge:un},lv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,cv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Gn=class extends bi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=lv,this.fragmentShader=cv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ts(e.uniforms),this.uniformsGroups=av(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Oe().setHex(s.value);break;case"v2":this.uniforms[i].value=new ye().fromArray(s.value);break;case"v3":this.uniforms[i].value=new P().fromArray(s.value);break;case"v4":this.uniforms[i].value=new bt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Ne().fromArray(s.value);break;case"m4":this.uniforms[i].value=new qe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},tl=class extends Gn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Xi=class extends bi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ic,this.normalScale=new ye(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new yi,this.combine=gl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},nl=class extends bi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=_p,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},il=class extends bi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function $s(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Aa(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var qi=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sl=class extends qi{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Lh,endingEnd:Lh}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Dh:r=e,a=2*t-i;break;case Nh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case Dh:o=e,c=2*i-t;break;case Nh:o=1,c=i+s[1]-s[0];break;default:o=e-1,c=t}let l=(i-t)*.5,h=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,u=this._weightNext,_=(i-t)/(s-t),b=_*_,m=b*_,g=-d*m+2*d*b-d*_,S=(1+d)*m+(-1.5-2*d)*b+(-.5+d)*_+1,E=(-1-u)*m+(1.5+u)*b+.5*_,M=u*m-u*b;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+S*o[l+C]+E*o[c+C]+M*o[f+C];return r}},rl=class extends qi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=(i-t)/(s-t),f=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*f+o[c+d]*h;return r}},ol=class extends qi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},al=class extends qi{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this.inTangents,f=this.outTangents;if(!h||!f){let _=(i-t)/(s-t),b=1-_;for(let m=0;m!==a;++m)r[m]=o[l+m]*b+o[c+m]*_;return r}let d=a*2,u=e-1;for(let _=0;_!==a;++_){let b=o[l+_],m=o[c+_],g=u*d+_*2,S=f[g],E=f[g+1],M=e*d+_*2,C=h[M],R=h[M+1],v=uv(i,t,S,C,s);r[_]=Np(v,b,E,R,m)}return r}};function Np(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function hv(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function uv(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Np(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let c=hv(r,e,t,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Ln=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=$s(t,this.TimeBufferType),this.values=$s(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:$s(e.times,Array),values:$s(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Aa(e.settings)&&(i.settings={inTangents:$s(e.settings.inTangents,Array),outTangents:$s(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new ol(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new al(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Yr:t=this.InterpolantFactoryMethodDiscrete;break;case za:t=this.InterpolantFactoryMethodLinear;break;case Pa:t=this.InterpolantFactoryMethodSmooth;break;case Ih:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ce("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Yr;case this.InterpolantFactoryMethodLinear:return za;case this.InterpolantFactoryMethodSmooth:return Pa;case this.InterpolantFactoryMethodBezier:return Ih}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Aa(this.settings)&&(kf(this.settings.inTangents,e),kf(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Aa(this.settings)&&(zf(this.settings.inTangents,e),zf(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(De("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(De("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){De("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){De("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&v_(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){De("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Pa,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],h=e[a+1];if(l!==h&&(a!==1||l!==e[0]))if(s)c=!0;else{let f=a*i,d=f-i,u=f+i;for(let _=0;_!==i;++_){let b=t[f+_];if(b!==t[d+_]||b!==t[u+_]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let f=a*i,d=o*i;for(let u=0;u!==i;++u)t[d+u]=t[f+u]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Aa(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function kf(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function zf(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ln.prototype.ValueTypeName="";Ln.prototype.TimeBufferType=Float32Array;Ln.prototype.ValueBufferType=Float32Array;Ln.prototype.DefaultInterpolation=za;var Yi=class extends Ln{constructor(e,t,i){super(e,t,i)}};Yi.prototype.ValueTypeName="bool";Yi.prototype.ValueBufferType=Array;Yi.prototype.DefaultInterpolation=Yr;Yi.prototype.InterpolantFactoryMethodLinear=void 0;Yi.prototype.InterpolantFactoryMethodSmooth=void 0;var ll=class extends Ln{constructor(e,t,i,s){super(e,t,i,s)}};ll.prototype.ValueTypeName="color";var cl=class extends Ln{constructor(e,t,i,s){super(e,t,i,s)}};cl.prototype.ValueTypeName="number";var hl=class extends qi{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-t)/(s-t),l=e*a;for(let h=l+a;l!==h;l+=4)rn.slerpFlat(r,0,o,l-a,o,l,c);return r}},po=class extends Ln{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new hl(this.times,this.values,this.getValueSize(),e)}};po.prototype.ValueTypeName="quaternion";po.prototype.InterpolantFactoryMethodSmooth=void 0;var Zi=class extends Ln{constructor(e,t,i){super(e,t,i)}};Zi.prototype.ValueTypeName="string";Zi.prototype.ValueBufferType=Array;Zi.prototype.DefaultInterpolation=Yr;Zi.prototype.InterpolantFactoryMethodLinear=void 0;Zi.prototype.InterpolantFactoryMethodSmooth=void 0;var ul=class extends Ln{constructor(e,t,i,s){super(e,t,i,s)}};ul.prototype.ValueTypeName="vector";var dl=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let u=l[f],_=l[f+1];if(u.global&&(u.lastIndex=0),u.test(h))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Up=new dl,fl=class{constructor(e){this.manager=e!==void 0?e:Up,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};fl.DEFAULT_MATERIAL_NAME="__DEFAULT";var mo=class extends Vt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Oe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},go=class extends mo{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Oe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Ph=new qe,Gf=new P,Vf=new P,pl=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ye(512,512),this.mapType=Mn,this.map=null,this.mapPass=null,this.matrix=new qe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Vi,this._frameExtents=new ye(1,1),this._viewportCount=1,this._viewports=[new bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Gf.setFromMatrixPosition(e.matrixWorld),t.position.copy(Gf),Vf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Vf),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Ph.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Ph,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===nr||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Ph)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ra=new P,Ca=new rn,ii=new P,_o=class extends Vt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new qe,this.projectionMatrix=new qe,this.projectionMatrixInverse=new qe,this.coordinateSystem=kn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ra,Ca,ii),ii.x===1&&ii.y===1&&ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ra,Ca,ii.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Ra,Ca,ii),ii.x===1&&ii.y===1&&ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ra,Ca,ii.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zi=new P,Hf=new ye,Wf=new ye,hn=class extends _o{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=sr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ks*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return sr*2*Math.atan(Math.tan(Ks*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){zi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(zi.x,zi.y).multiplyScalar(-e/zi.z),zi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(zi.x,zi.y).multiplyScalar(-e/zi.z)}getViewSize(e,t){return this.getViewBounds(e,Hf,Wf),t.subVectors(Wf,Hf)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ks*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var vo=class extends _o{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Uh=class extends pl{constructor(){super(new vo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},yo=class extends mo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vt.DEFAULT_UP),this.updateMatrix(),this.target=new Vt,this.shadow=new Uh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var js=-90,Js=1,cr=class extends Vt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new hn(js,Js,e,t);s.layers=this.layers,this.add(s);let r=new hn(js,Js,e,t);r.layers=this.layers,this.add(r);let o=new hn(js,Js,e,t);o.layers=this.layers,this.add(o);let a=new hn(js,Js,e,t);a.layers=this.layers,this.add(a);let c=new hn(js,Js,e,t);c.layers=this.layers,this.add(c);let l=new hn(js,Js,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===kn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===nr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),u=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,d,u),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},ml=class extends hn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mu="\\[\\]\\.:\\/",dv=new RegExp("["+mu+"]","g"),gu="[^"+mu+"]",fv="[^"+mu.replace("\\.","")+"]",pv=/((?:WC+[\/:])*)/.source.replace("WC",gu),mv=/(WCOD+)?/.source.replace("WCOD",fv),gv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gu),_v=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gu),vv=new RegExp("^"+pv+mv+gv+_v+"$"),yv=["material","materials","bones","map"],Oh=class{constructor(e,t,i){let s=i||_t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},_t=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(dv,"")}static parseTrackName(e){let t=vv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);yv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=i(a.children);if(c)return c}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ce("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=t.objectIndex;switch(i){case"materials":if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){De("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){De("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===l){l=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){De("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){De("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(l!==void 0){if(e[l]===void 0){De("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;De("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};_t.Composite=Oh;_t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};_t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};_t.prototype.GetterByBindingType=[_t.prototype._getValue_direct,_t.prototype._getValue_array,_t.prototype._getValue_arrayElement,_t.prototype._getValue_toArray];_t.prototype.SetterByBindingTypeAndVersioning=[[_t.prototype._setValue_direct,_t.prototype._setValue_direct_setNeedsUpdate,_t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_array,_t.prototype._setValue_array_setNeedsUpdate,_t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_arrayElement,_t.prototype._setValue_arrayElement_setNeedsUpdate,_t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_fromArray,_t.prototype._setValue_fromArray_setNeedsUpdate,_t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var tT=new Float32Array(1);var Xf=new qe,xo=class{constructor(e,t,i=0,s=1/0){this.ray=new Gi(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new or,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):De("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Xf.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Xf),this}intersectObject(e,t=!0,i=[]){return Fh(e,this,i,t),i.sort(qf),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Fh(e[s],this,i,t);return i.sort(qf),i}};function qf(n,e){return n.distance-e.distance}function Fh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Fh(r[o],e,t,!0)}}var hr=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(Ve(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Bh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var bo=class extends $n{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function _u(n,e,t,i){let s=xv(i);switch(t){case iu:return n*e;case Ml:return n*e/s.components*s.byteLength;case wl:return n*e/s.components*s.byteLength;case Ki:return n*e*2/s.components*s.byteLength;case Tl:return n*e*2/s.components*s.byteLength;case su:return n*e*3/s.components*s.byteLength;case Kn:return n*e*4/s.components*s.byteLength;case El:return n*e*4/s.components*s.byteLength;case Mo:case wo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case To:case Eo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Rl:case Pl:return Math.max(n,16)*Math.max(e,8)/4;case Al:case Cl:return Math.max(n,8)*Math.max(e,8)/2;case Il:case Ll:case Nl:case Ul:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Dl:case Ao:case Ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Bl:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case kl:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case zl:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Gl:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Vl:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Hl:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Wl:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Xl:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ql:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Yl:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Zl:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case $l:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case jl:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Jl:case Kl:case Ql:return Math.ceil(n/4)*Math.ceil(e/4)*16;case ec:case tc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ro:case nc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function xv(n){switch(n){case Mn:case Qh:return{byteLength:1,components:1};case pr:case eu:case Jn:return{byteLength:2,components:1};case bl:case Sl:return{byteLength:2,components:4};case jn:case xl:case Hn:return{byteLength:4,components:1};case tu:case nu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ce("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function im(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Sv(n){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,f=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,h),a.onUploadCallback();let u;if(l instanceof Float32Array)u=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)u=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?u=n.HALF_FLOAT:u=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)u=n.SHORT;else if(l instanceof Uint32Array)u=n.UNSIGNED_INT;else if(l instanceof Int32Array)u=n.INT;else if(l instanceof Int8Array)u=n.BYTE;else if(l instanceof Uint8Array)u=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)u=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:u,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,c,l){let h=c.array,f=c.updateRanges;if(n.bindBuffer(l,a),f.length===0)n.bufferSubData(l,0,h);else{f.sort((u,_)=>u.start-_.start);let d=0;for(let u=1;u<f.length;u++){let _=f[d],b=f[u];b.start<=_.start+_.count+1?_.count=Math.max(_.count,b.start+b.count-_.start):(++d,f[d]=b)}f.length=d+1;for(let u=0,_=f.length;u<_;u++){let b=f[u];n.bufferSubData(l,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(n.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Mv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,wv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Tv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ev=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Av=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Rv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Pv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Iv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Lv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Dv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Nv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Uv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Ov=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Fv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Bv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,kv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,zv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Gv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Vv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Wv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Xv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,qv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Yv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Zv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$v=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,jv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Kv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Qv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,e0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,t0=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,n0=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,i0=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,s0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,r0=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,o0=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,a0=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,l0=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,c0=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,h0=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,u0=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,d0=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,f0=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,p0=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,m0=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,g0=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,_0=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,v0=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,y0=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,x0=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,b0=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,S0=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,M0=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,w0=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,T0=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,E0=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,A0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,R0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,C0=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,P0=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,I0=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,L0=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,D0=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,N0=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,U0=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,O0=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,F0=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,B0=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,k0=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,z0=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,G0=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,V0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,H0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,W0=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,X0=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,q0=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Y0=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Z0=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$0=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,j0=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,J0=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,K0=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Q0=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ey=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ty=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ny=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,iy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,sy=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,ry=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,oy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ay=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ly=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,cy=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,hy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,uy=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,dy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,fy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,py=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,my=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,gy=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,_y=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,vy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,by=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Sy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,My=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ty=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ey=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ay=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ry=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Cy=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Py=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Iy=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Ly=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Dy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ny=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Uy=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Oy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Fy=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,By=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ky=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zy=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Gy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Hy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Wy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Xy=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qy=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Yy=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zy=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$y=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jy=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Jy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ky=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Qy=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ex=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,tx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,He={alphahash_fragment:Mv,alphahash_pars_fragment:wv,alphamap_fragment:Tv,alphamap_pars_fragment:Ev,alphatest_fragment:Av,alphatest_pars_fragment:Rv,aomap_fragment:Cv,aomap_pars_fragment:Pv,batching_pars_vertex:Iv,batching_vertex:Lv,begin_vertex:Dv,beginnormal_vertex:Nv,bsdfs:Uv,iridescence_fragment:Ov,bumpmap_pars_fragment:Fv,clipping_planes_fragment:Bv,clipping_planes_pars_fragment:kv,clipping_planes_pars_vertex:zv,clipping_planes_vertex:Gv,color_fragment:Vv,color_pars_fragment:Hv,color_pars_vertex:Wv,color_vertex:Xv,common:qv,defaultnormal_vertex:Yv,displacementmap_pars_vertex:Zv,displacementmap_vertex:$v,emissivemap_fragment:jv,emissivemap_pars_fragment:Jv,colorspace_fragment:Kv,colorspace_pars_fragment:Qv,envmap_fragment:e0,envmap_common_pars_fragment:t0,envmap_pars_fragment:n0,envmap_pars_vertex:i0,envmap_physical_pars_fragment:p0,envmap_vertex:s0,fog_vertex:r0,fog_pars_vertex:o0,fog_fragment:a0,fog_pars_fragment:l0,gradientmap_pars_fragment:c0,lightmap_pars_fragment:h0,lights_lambert_fragment:u0,lights_lambert_pars_fragment:d0,lights_pars_begin:f0,lights_toon_fragment:m0,lights_toon_pars_fragment:g0,lights_phong_fragment:_0,lights_phong_pars_fragment:v0,lights_physical_fragment:y0,lights_physical_pars_fragment:x0,lights_fragment_begin:b0,lights_fragment_maps:S0,lights_fragment_end:M0,lightprobes_pars_fragment:w0,logdepthbuf_fragment:T0,logdepthbuf_pars_fragment:E0,logdepthbuf_pars_vertex:A0,logdepthbuf_vertex:R0,map_fragment:C0,map_pars_fragment:P0,map_particle_fragment:I0,map_particle_pars_fragment:L0,metalnessmap_fragment:D0,metalnessmap_pars_fragment:N0,morphinstance_vertex:U0,morphcolor_vertex:O0,morphnormal_vertex:F0,morphtarget_pars_vertex:B0,morphtarget_vertex:k0,normal_fragment_begin:z0,normal_fragment_maps:G0,normal_pars_fragment:V0,normal_pars_vertex:H0,normal_vertex:W0,normalmap_pars_fragment:X0,clearcoat_normal_fragment_begin:q0,clearcoat_normal_fragment_maps:Y0,clearcoat_pars_fragment:Z0,iridescence_pars_fragment:$0,opaque_fragment:j0,packing:J0,premultiplied_alpha_fragment:K0,project_vertex:Q0,dithering_fragment:ey,dithering_pars_fragment:ty,roughnessmap_fragment:ny,roughnessmap_pars_fragment:iy,shadowmap_pars_fragment:sy,shadowmap_pars_vertex:ry,shadowmap_vertex:oy,shadowmask_pars_fragment:ay,skinbase_vertex:ly,skinning_pars_vertex:cy,skinning_vertex:hy,skinnormal_vertex:uy,specularmap_fragment:dy,specularmap_pars_fragment:fy,tonemapping_fragment:py,tonemapping_pars_fragment:my,transmission_fragment:gy,transmission_pars_fragment:_y,uv_pars_fragment:vy,uv_pars_vertex:yy,uv_vertex:xy,worldpos_vertex:by,background_vert:Sy,background_frag:My,backgroundCube_vert:wy,backgroundCube_frag:Ty,cube_vert:Ey,cube_frag:Ay,depth_vert:Ry,depth_frag:Cy,distance_vert:Py,distance_frag:Iy,equirect_vert:Ly,equirect_frag:Dy,linedashed_vert:Ny,linedashed_frag:Uy,meshbasic_vert:Oy,meshbasic_frag:Fy,meshlambert_vert:By,meshlambert_frag:ky,meshmatcap_vert:zy,meshmatcap_frag:Gy,meshnormal_vert:Vy,meshnormal_frag:Hy,meshphong_vert:Wy,meshphong_frag:Xy,meshphysical_vert:qy,meshphysical_frag:Yy,meshtoon_vert:Zy,meshtoon_frag:$y,points_vert:jy,points_frag:Jy,shadow_vert:Ky,shadow_frag:Qy,sprite_vert:ex,sprite_frag:tx},me={common:{diffuse:{value:new Oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ne},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ne}},envmap:{envMap:{value:null},envMapRotation:{value:new Ne},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ne},normalScale:{value:new ye(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0},uvTransform:{value:new Ne}},sprite:{diffuse:{value:new Oe(16777215)},opacity:{value:1},center:{value:new ye(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ne},alphaMap:{value:null},alphaMapTransform:{value:new Ne},alphaTest:{value:0}}},oi={basic:{uniforms:un([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.fog]),vertexShader:He.meshbasic_vert,fragmentShader:He.meshbasic_frag},lambert:{uniforms:un([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.fog,me.lights,{emissive:{value:new Oe(0)},envMapIntensity:{value:1}}]),vertexShader:He.meshlambert_vert,fragmentShader:He.meshlambert_frag},phong:{uniforms:un([me.common,me.specularmap,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.fog,me.lights,{emissive:{value:new Oe(0)},specular:{value:new Oe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:He.meshphong_vert,fragmentShader:He.meshphong_frag},standard:{uniforms:un([me.common,me.envmap,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.roughnessmap,me.metalnessmap,me.fog,me.lights,{emissive:{value:new Oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag},toon:{uniforms:un([me.common,me.aomap,me.lightmap,me.emissivemap,me.bumpmap,me.normalmap,me.displacementmap,me.gradientmap,me.fog,me.lights,{emissive:{value:new Oe(0)}}]),vertexShader:He.meshtoon_vert,fragmentShader:He.meshtoon_frag},matcap:{uniforms:un([me.common,me.bumpmap,me.normalmap,me.displacementmap,me.fog,{matcap:{value:null}}]),vertexShader:He.meshmatcap_vert,fragmentShader:He.meshmatcap_frag},points:{uniforms:un([me.points,me.fog]),vertexShader:He.points_vert,fragmentShader:He.points_frag},dashed:{uniforms:un([me.common,me.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:He.linedashed_vert,fragmentShader:He.linedashed_frag},depth:{uniforms:un([me.common,me.displacementmap]),vertexShader:He.depth_vert,fragmentShader:He.depth_frag},normal:{uniforms:un([me.common,me.bumpmap,me.normalmap,me.displacementmap,{opacity:{value:1}}]),vertexShader:He.meshnormal_vert,fragmentShader:He.meshnormal_frag},sprite:{uniforms:un([me.sprite,me.fog]),vertexShader:He.sprite_vert,fragmentShader:He.sprite_frag},background:{uniforms:{uvTransform:{value:new Ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:He.background_vert,fragmentShader:He.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ne}},vertexShader:He.backgroundCube_vert,fragmentShader:He.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:He.cube_vert,fragmentShader:He.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:He.equirect_vert,fragmentShader:He.equirect_frag},distance:{uniforms:un([me.common,me.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:He.distance_vert,fragmentShader:He.distance_frag},shadow:{uniforms:un([me.lights,me.fog,{color:{value:new Oe(0)},opacity:{value:1}}]),vertexShader:He.shadow_vert,fragmentShader:He.shadow_frag}};oi.physical={uniforms:un([oi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ne},clearcoatNormalScale:{value:new ye(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ne},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ne},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ne},sheen:{value:0},sheenColor:{value:new Oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ne},transmissionSamplerSize:{value:new ye},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ne},attenuationDistance:{value:0},attenuationColor:{value:new Oe(0)},specularColor:{value:new Oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ne},anisotropyVector:{value:new ye},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ne}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag};var sc={r:0,b:0,g:0},nx=new qe,sm=new Ne;sm.set(-1,0,0,0,1,0,0,0,1);function ix(n,e,t,i,s,r){let o=new Oe(0),a=s===!0?0:1,c,l,h=null,f=0,d=null;function u(S){let E=S.isScene===!0?S.background:null;if(E&&E.isTexture){let M=S.backgroundBlurriness>0;E=e.get(E,M)}return E}function _(S){let E=!1,M=u(S);M===null?m(o,a):M&&M.isColor&&(m(M,1),E=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(S,E){let M=u(E);M&&M.isCubeTexture?(l===void 0&&(l=new mt(new Wi(1,1,1),new Gn({name:"BackgroundCubeMaterial",uniforms:Ts(oi.backgroundCube.uniforms),vertexShader:oi.backgroundCube.vertexShader,fragmentShader:oi.backgroundCube.fragmentShader,side:vn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,R,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=M,l.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(nx.makeRotationFromEuler(E.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(sm),l.material.toneMapped=Ke.getTransfer(M.colorSpace)!==rt,(h!==M||f!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new mt(new ys(2,2),new Gn({name:"BackgroundMaterial",uniforms:Ts(oi.background.uniforms),vertexShader:oi.background.vertexShader,fragmentShader:oi.background.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.toneMapped=Ke.getTransfer(M.colorSpace)!==rt,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||f!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function m(S,E){S.getRGB(sc,pu(n)),t.buffers.color.setClear(sc.r,sc.g,sc.b,E,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,E=1){o.set(S),a=E,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,m(o,a)},render:_,addToRenderList:b,dispose:g}}function sx(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(O,G,W,D,Y){let K=!1,H=f(O,D,W,G);r!==H&&(r=H,l(r.object)),K=u(O,D,W,Y),K&&_(O,D,W,Y),Y!==null&&e.update(Y,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,M(O,G,W,D),Y!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(Y).buffer))}function c(){return n.createVertexArray()}function l(O){return n.bindVertexArray(O)}function h(O){return n.deleteVertexArray(O)}function f(O,G,W,D){let Y=D.wireframe===!0,K=i[G.id];K===void 0&&(K={},i[G.id]=K);let H=O.isInstancedMesh===!0?O.id:0,ie=K[H];ie===void 0&&(ie={},K[H]=ie);let q=ie[W.id];q===void 0&&(q={},ie[W.id]=q);let ee=q[Y];return ee===void 0&&(ee=d(c()),q[Y]=ee),ee}function d(O){let G=[],W=[],D=[];for(let Y=0;Y<t;Y++)G[Y]=0,W[Y]=0,D[Y]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:D,object:O,attributes:{},index:null}}function u(O,G,W,D){let Y=r.attributes,K=G.attributes,H=0,ie=W.getAttributes();for(let q in ie)if(ie[q].location>=0){let te=Y[q],Te=K[q];if(Te===void 0&&(q==="instanceMatrix"&&O.instanceMatrix&&(Te=O.instanceMatrix),q==="instanceColor"&&O.instanceColor&&(Te=O.instanceColor)),te===void 0||te.attribute!==Te||Te&&te.data!==Te.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function _(O,G,W,D){let Y={},K=G.attributes,H=0,ie=W.getAttributes();for(let q in ie)if(ie[q].location>=0){let te=K[q];te===void 0&&(q==="instanceMatrix"&&O.instanceMatrix&&(te=O.instanceMatrix),q==="instanceColor"&&O.instanceColor&&(te=O.instanceColor));let Te={};Te.attribute=te,te&&te.data&&(Te.data=te.data),Y[q]=Te,H++}r.attributes=Y,r.attributesNum=H,r.index=D}function b(){let O=r.newAttributes;for(let G=0,W=O.length;G<W;G++)O[G]=0}function m(O){g(O,0)}function g(O,G){let W=r.newAttributes,D=r.enabledAttributes,Y=r.attributeDivisors;W[O]=1,D[O]===0&&(n.enableVertexAttribArray(O),D[O]=1),Y[O]!==G&&(n.vertexAttribDivisor(O,G),Y[O]=G)}function S(){let O=r.newAttributes,G=r.enabledAttributes;for(let W=0,D=G.length;W<D;W++)G[W]!==O[W]&&(n.disableVertexAttribArray(W),G[W]=0)}function E(O,G,W,D,Y,K,H){H===!0?n.vertexAttribIPointer(O,G,W,Y,K):n.vertexAttribPointer(O,G,W,D,Y,K)}function M(O,G,W,D){b();let Y=D.attributes,K=W.getAttributes(),H=G.defaultAttributeValues;for(let ie in K){let q=K[ie];if(q.location>=0){let ee=Y[ie];if(ee===void 0&&(ie==="instanceMatrix"&&O.instanceMatrix&&(ee=O.instanceMatrix),ie==="instanceColor"&&O.instanceColor&&(ee=O.instanceColor)),ee!==void 0){let te=ee.normalized,Te=ee.itemSize,Fe=e.get(ee);if(Fe===void 0)continue;let j=Fe.buffer,ge=Fe.type,be=Fe.bytesPerElement,Pe=ge===n.INT||ge===n.UNSIGNED_INT||ee.gpuType===xl;if(ee.isInterleavedBufferAttribute){let _e=ee.data,ke=_e.isInterleavedBuffer===!0?_e.stride:_e.itemSize,Pt=ee.offset;if(_e.isInstancedInterleavedBuffer||_e.isInstancedBufferAttribute){for(let Le=0;Le<q.locationSize;Le++)g(q.location+Le,_e.meshPerAttribute);O.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=_e.meshPerAttribute*_e.count)}else for(let Le=0;Le<q.locationSize;Le++)m(q.location+Le);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Le=0;Le<q.locationSize;Le++)E(q.location+Le,Te/q.locationSize,ge,te,ke*be,(Pt+Te/q.locationSize*Le)*be,Pe)}else{if(ee.isInstancedBufferAttribute){for(let _e=0;_e<q.locationSize;_e++)g(q.location+_e,ee.meshPerAttribute);O.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let _e=0;_e<q.locationSize;_e++)m(q.location+_e);n.bindBuffer(n.ARRAY_BUFFER,j);for(let _e=0;_e<q.locationSize;_e++)E(q.location+_e,Te/q.locationSize,ge,te,Te*be,Te/q.locationSize*_e*be,Pe)}}else if(H!==void 0){let te=H[ie];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(q.location,te);break;case 3:n.vertexAttrib3fv(q.location,te);break;case 4:n.vertexAttrib4fv(q.location,te);break;default:n.vertexAttrib1fv(q.location,te)}}}}S()}function C(){B();for(let O in i){let G=i[O];for(let W in G){let D=G[W];for(let Y in D){let K=D[Y];for(let H in K)h(K[H].object),delete K[H];delete D[Y]}}delete i[O]}}function R(O){if(i[O.id]===void 0)return;let G=i[O.id];for(let W in G){let D=G[W];for(let Y in D){let K=D[Y];for(let H in K)h(K[H].object),delete K[H];delete D[Y]}}delete i[O.id]}function v(O){for(let G in i){let W=i[G];for(let D in W){let Y=W[D];if(Y[O.id]===void 0)continue;let K=Y[O.id];for(let H in K)h(K[H].object),delete K[H];delete Y[O.id]}}}function w(O){for(let G in i){let W=i[G],D=O.isInstancedMesh===!0?O.id:0,Y=W[D];if(Y!==void 0){for(let K in Y){let H=Y[K];for(let ie in H)h(H[ie].object),delete H[ie];delete Y[K]}delete W[D],Object.keys(W).length===0&&delete i[G]}}}function B(){N(),o=!0,r!==s&&(r=s,l(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:R,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:m,disableUnusedAttributes:S}}function rx(n,e,t){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),t.update(l,i,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let d=0;for(let u=0;u<h;u++)d+=l[u];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function ox(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Kn&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let w=v===Jn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Mn&&v!==Hn&&!w&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(Ce("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ce("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ce("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let u=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),R=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:u,maxVertexTextures:_,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:S,maxVaryings:E,maxFragmentUniforms:M,maxSamples:C,samples:R}}function ax(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Cn,a=new Ne,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let u=f.length!==0||d||i!==0||s;return s=d,i=f.length,u},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){t=h(f,d,0)},this.setState=function(f,d,u){let _=f.clippingPlanes,b=f.clipIntersection,m=f.clipShadows,g=n.get(f);if(!s||_===null||_.length===0||r&&!m)r?h(null):l();else{let S=r?0:i,E=S*4,M=g.clippingState||null;c.value=M,M=h(_,d,E,u);for(let C=0;C!==E;++C)M[C]=t[C];g.clippingState=M,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=S}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,d,u,_){let b=f!==null?f.length:0,m=null;if(b!==0){if(m=c.value,_!==!0||m===null){let g=u+b*4,S=d.matrixWorldInverse;a.getNormalMatrix(S),(m===null||m.length<g)&&(m=new Float32Array(g));for(let E=0,M=u;E!==b;++E,M+=4)o.copy(f[E]).applyMatrix4(S,a),o.normal.toArray(m,M),m[M+3]=o.constant}c.value=m,c.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var Io=class extends In{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new so(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Wi(5,5,5),r=new Gn({name:"CubemapFromEquirect",uniforms:Ts(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:vn,blending:bs});r.uniforms.tEquirect.value=t;let o=new mt(s,r),a=t.minFilter;return t.minFilter===wi&&(t.minFilter=gn),new cr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Op=256,lx=3,cx=20,rm=256,om=16,hx=3,ux=new P,dx=new Oe,oc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new cr(1,10,null),this._boxMesh=new mt(new Wi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=ux}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,u=c.autoClearDepth,_=c.autoClearStencil,b=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,b===null&&(e.background=c.getClearColor(dx));let m=new cr(i,s,h);return m.position.copy(a),m.update(c,e),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=u,c.autoClearStencil=_,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=kp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Bp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Op,uu(e))}_fromTexture(e,t){e.mapping===Ms||e.mapping===fr?this._setSize(e.image.length===0?Op:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Fp(e,!1,!1),i=Math.log2(e)-lx;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Fp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ms||e.mapping===fr?(this._cubemapMaterial===null&&(this._cubemapMaterial=kp()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Bp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=fx(),this._integrationMaterial=px());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/om);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-hx)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(rm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=mx());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Fp(n,e,t){return new Io(n,{minFilter:wi,generateMipmaps:e,type:Jn,colorSpace:Zr,depthBuffer:t})}function Lo(n,e,t){return new Gn({name:n,uniforms:e,vertexShader:He.cube_vert,fragmentShader:t,side:vn,blending:bs,depthTest:!1,depthWrite:!1})}function fx(){return Lo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${rm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function px(){return Lo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:om}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function mx(){return Lo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${cx}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Bp(){return Lo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function kp(){return Lo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function gx(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,u=!1){return d==null?null:u?o(d):r(d)}function r(d){if(d&&d.isTexture){let u=d.mapping;if(u===_l||u===vl)if(e.has(d)){let _=e.get(d).texture;return a(_,d.mapping)}else{let _=d.image;if(_&&_.height>0){let b=new Io(_.height);return b.fromEquirectangularTexture(n,d),e.set(d,b),d.addEventListener("dispose",l),a(b.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let u=d.mapping,_=u===_l||u===vl,b=u===Ms||u===fr;if(_||b){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new oc(n)),m=_?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let S=d.image;return _&&S&&S.height>0||b&&S&&c(S)?(i===null&&(i=new oc(n)),m=_?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,u){return u===_l?d.mapping=Ms:u===vl&&(d.mapping=fr),d}function c(d){let u=0,_=6;for(let b=0;b<_;b++)d[b]!==void 0&&u++;return u===_}function l(d){let u=d.target;u.removeEventListener("dispose",l);let _=e.get(u);_!==void 0&&(e.delete(u),_.dispose())}function h(d){let u=d.target;u.removeEventListener("dispose",h);let _=t.get(u);_!==void 0&&(t.delete(u),_.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function _x(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Hr("WebGLRenderer: "+i+" extension not supported."),s}}}function vx(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){c(_.target)}function c(_){_.index!==null&&e.remove(_.index);for(let m in _.attributes)e.remove(_.attributes[m]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let b=r.get(_);b&&(e.remove(b),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function l(_,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function h(_){let b=_.attributes;for(let m in b)e.update(b[m],n.ARRAY_BUFFER)}function f(_){let b=_.index,m=_.attributes.position,g=0;if(m===void 0)return;let S=b!==null?b.array.length:m.array.length/3-1,E=m.count>=65535?eo:Qr,M=new E(Math.ceil(S/3)*6,1),C=M.array;if(b!==null){let v=b.array;g=b.version;for(let w=0,B=0;w<S;w+=3){let N=v[w+0],O=v[w+1],G=v[w+2];C[B++]=N,C[B++]=O,C[B++]=O,C[B++]=G,C[B++]=G,C[B++]=N}}else{g=m.version;for(let v=0,w=0;v<S;v+=3){let B=v+0,N=v+1,O=v+2;C[w++]=B,C[w++]=N,C[w++]=N,C[w++]=O,C[w++]=O,C[w++]=B}}M.version=g;let R=r.get(_);R&&e.remove(R),r.set(_,M)}function d(_){let b=r.get(_);if(b){let m=_.index;m!==null&&b.version<m.version&&f(_)}else f(_);return r.get(_)}function u(){for(let _ in s){let b=s[_].deref();b!==void 0&&c(b)}}return{get:l,update:h,getWireframeAttribute:d,dispose:u}}function yx(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function c(f,d){n.drawElements(i,d,r,f*o),t.update(d,i,1)}function l(f,d,u){u!==0&&(n.drawElementsInstanced(i,d,r,f*o,u),t.update(d,i,u))}function h(f,d,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,u);let b=0;for(let m=0;m<u;m++)b+=d[m];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function xx(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:De("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function bx(n,e,t){let i=new WeakMap,s=new bt;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==f){let B=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let u=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],E=0;u===!0&&(E=1),_===!0&&(E=2),b===!0&&(E=3);let M=a.attributes.position.count*E,C=1;M>e.maxTextureSize&&(C=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let R=new Float32Array(M*C*4*f),v=new Jr(R,M,C,f);v.type=Hn,v.needsUpdate=!0;let w=E*4;for(let N=0;N<f;N++){let O=m[N],G=g[N],W=S[N],D=M*C*4*N;for(let Y=0;Y<O.count;Y++){let K=Y*w;u===!0&&(s.fromBufferAttribute(O,Y),R[D+K+0]=s.x,R[D+K+1]=s.y,R[D+K+2]=s.z,R[D+K+3]=0),_===!0&&(s.fromBufferAttribute(G,Y),R[D+K+4]=s.x,R[D+K+5]=s.y,R[D+K+6]=s.z,R[D+K+7]=0),b===!0&&(s.fromBufferAttribute(W,Y),R[D+K+8]=s.x,R[D+K+9]=s.y,R[D+K+10]=s.z,R[D+K+11]=W.itemSize===4?s.w:1)}}d={count:f,texture:v,size:new ye(M,C)},i.set(a,d),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let u=0;for(let b=0;b<l.length;b++)u+=l[b];let _=a.morphTargetsRelative?1:1-u;c.getUniforms().setValue(n,"morphTargetBaseInfluence",_),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Sx(n,e,t,i,s){let r=new WeakMap;function o(l){let h=s.render.frame,f=l.geometry,d=e.get(l,f);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let u=l.skeleton;r.get(u)!==h&&(u.update(),r.set(u,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Mx={[Xh]:"LINEAR_TONE_MAPPING",[qh]:"REINHARD_TONE_MAPPING",[Yh]:"CINEON_TONE_MAPPING",[Zh]:"ACES_FILMIC_TONE_MAPPING",[jh]:"AGX_TONE_MAPPING",[Jh]:"NEUTRAL_TONE_MAPPING",[$h]:"CUSTOM_TONE_MAPPING"};function wx(n,e,t,i,s,r){let o=new In(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Sn;h.setAttribute("position",new Rt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Rt([0,2,0,0,2,0],2));let f=new tl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new mt(h,f),u=new vo(-1,1,1,-1,0,1),_=null,b=null,m=!1,g,S=null,E=[],M=!1;this.setSize=function(C,R){o.setSize(C,R),a!==null&&a.setSize(C,R),c!==null&&c.setSize(C,R);for(let v=0;v<E.length;v++){let w=E[v];w.setSize&&w.setSize(C,R)}},this.setEffects=function(C){E=C,M=E.length>0&&E[0].isRenderPass===!0;let R=o.width,v=o.height;E.length>0&&a===null&&(a=new In(R,v,{type:Jn,depthBuffer:!1,stencilBuffer:!1}),c=new In(R,v,{type:Jn,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&E.some(B=>B.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&l===null&&(l=new Mi(R,v),r===!0&&(l.format=Ti,l.type=ws)),o.dispose(),o.depthTexture=w?l:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let B=0;B<E.length;B++){let N=E[B];N.setSize&&N.setSize(R,v),w&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(l)}},this.begin=function(C,R){if(m||C.toneMapping===Vn&&E.length===0)return!1;if(S=R,R!==null){let v=R.width,w=R.height;(o.width!==v||o.height!==w)&&this.setSize(v,w)}return M===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=Vn,!0},this.hasRenderPass=function(){return M},this.end=function(C,R){C.toneMapping=g,m=!0;let v=o,w=a;for(let B=0;B<E.length;B++){let N=E[B];N.enabled!==!1&&(N.render(C,w,v,R),N.needsSwap!==!1&&(v=w,w=w===a?c:a))}if(_!==C.outputColorSpace||b!==C.toneMapping){_=C.outputColorSpace,b=C.toneMapping,f.defines={},Ke.getTransfer(_)===rt&&(f.defines.SRGB_TRANSFER="");let B=Mx[b];B&&(f.defines[B]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(S),C.render(d,u),S=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var am=new _n,lm=new Mi(1,1),cm=new oo(1),hm=new Jr,um=new Ha,dm=new so,zp=[],Gp=[],Vp=new Float32Array(16),Hp=new Float32Array(9),Wp=new Float32Array(4);function vr(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=zp[s];if(r===void 0&&(r=new Float32Array(s),zp[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Ht(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Wt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function lc(n,e){let t=Gp[e];t===void 0&&(t=new Int32Array(e),Gp[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Tx(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function Ex(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ht(t,e))return;n.uniform2fv(this.addr,e),Wt(t,e)}}function Ax(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ht(t,e))return;n.uniform3fv(this.addr,e),Wt(t,e)}}function Rx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ht(t,e))return;n.uniform4fv(this.addr,e),Wt(t,e)}}function Cx(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ht(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Wt(t,e)}else{if(Ht(t,i))return;Wp.set(i),n.uniformMatrix2fv(this.addr,!1,Wp),Wt(t,i)}}function Px(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ht(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Wt(t,e)}else{if(Ht(t,i))return;Hp.set(i),n.uniformMatrix3fv(this.addr,!1,Hp),Wt(t,i)}}function Ix(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ht(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Wt(t,e)}else{if(Ht(t,i))return;Vp.set(i),n.uniformMatrix4fv(this.addr,!1,Vp),Wt(t,i)}}function Lx(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Dx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ht(t,e))return;n.uniform2iv(this.addr,e),Wt(t,e)}}function Nx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ht(t,e))return;n.uniform3iv(this.addr,e),Wt(t,e)}}function Ux(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ht(t,e))return;n.uniform4iv(this.addr,e),Wt(t,e)}}function Ox(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Fx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ht(t,e))return;n.uniform2uiv(this.addr,e),Wt(t,e)}}function Bx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ht(t,e))return;n.uniform3uiv(this.addr,e),Wt(t,e)}}function kx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ht(t,e))return;n.uniform4uiv(this.addr,e),Wt(t,e)}}function cc(n){return n.version===0&&(n.compareFunction=au,n.needsUpdate=!0),n}function zx(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=cc(lm):r=am,t.setTexture2D(e||r,s)}function Gx(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||um,s)}function Vx(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=cc(cm):r=dm,t.setTextureCube(e||r,s)}function Hx(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||hm,s)}function Wx(n){switch(n){case 5126:return Tx;case 35664:return Ex;case 35665:return Ax;case 35666:return Rx;case 35674:return Cx;case 35675:return Px;case 35676:return Ix;case 5124:case 35670:return Lx;case 35667:case 35671:return Dx;case 35668:case 35672:return Nx;case 35669:case 35673:return Ux;case 5125:return Ox;case 36294:return Fx;case 36295:return Bx;case 36296:return kx;case 35678:case 36198:case 36298:case 36306:case 35682:return zx;case 35679:case 36299:case 36307:return Gx;case 35680:case 36300:case 36308:case 36293:return Vx;case 36289:case 36303:case 36311:case 36292:return Hx}}function Xx(n,e){n.uniform1fv(this.addr,e)}function qx(n,e){let t=vr(e,this.size,2);n.uniform2fv(this.addr,t)}function Yx(n,e){let t=vr(e,this.size,3);n.uniform3fv(this.addr,t)}function Zx(n,e){let t=vr(e,this.size,4);n.uniform4fv(this.addr,t)}function $x(n,e){let t=vr(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function jx(n,e){let t=vr(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Jx(n,e){let t=vr(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Kx(n,e){n.uniform1iv(this.addr,e)}function Qx(n,e){n.uniform2iv(this.addr,e)}function eb(n,e){n.uniform3iv(this.addr,e)}function tb(n,e){n.uniform4iv(this.addr,e)}function nb(n,e){n.uniform1uiv(this.addr,e)}function ib(n,e){n.uniform2uiv(this.addr,e)}function sb(n,e){n.uniform3uiv(this.addr,e)}function rb(n,e){n.uniform4uiv(this.addr,e)}function ob(n,e,t){let i=this.cache,s=e.length,r=lc(t,s);Ht(i,r)||(n.uniform1iv(this.addr,r),Wt(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=cc(lm):o=am;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function ab(n,e,t){let i=this.cache,s=e.length,r=lc(t,s);Ht(i,r)||(n.uniform1iv(this.addr,r),Wt(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||um,r[o])}function lb(n,e,t){let i=this.cache,s=e.length,r=lc(t,s);Ht(i,r)||(n.uniform1iv(this.addr,r),Wt(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=cc(cm):o=dm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function cb(n,e,t){let i=this.cache,s=e.length,r=lc(t,s);Ht(i,r)||(n.uniform1iv(this.addr,r),Wt(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||hm,r[o])}function hb(n){switch(n){case 5126:return Xx;case 35664:return qx;case 35665:return Yx;case 35666:return Zx;case 35674:return $x;case 35675:return jx;case 35676:return Jx;case 5124:case 35670:return Kx;case 35667:case 35671:return Qx;case 35668:case 35672:return eb;case 35669:case 35673:return tb;case 5125:return nb;case 36294:return ib;case 36295:return sb;case 36296:return rb;case 35678:case 36198:case 36298:case 36306:case 35682:return ob;case 35679:case 36299:case 36307:return ab;case 35680:case 36300:case 36308:case 36293:return lb;case 36289:case 36303:case 36311:case 36292:return cb}}var xu=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Wx(t.type)}},bu=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=hb(t.type)}},Su=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},vu=/(\w+)(\])?(\[|\.)?/g;function Xp(n,e){n.seq.push(e),n.map[e.id]=e}function ub(n,e,t){let i=n.name,s=i.length;for(vu.lastIndex=0;;){let r=vu.exec(i),o=vu.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Xp(t,l===void 0?new xu(a,n,e):new bu(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Su(a),Xp(t,f)),t=f}}}var _r=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);ub(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function qp(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var db=37297,fb=0;function pb(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Yp=new Ne;function mb(n){Ke._getMatrix(Yp,Ke.workingColorSpace,n);let e=`mat3( ${Yp.elements.map(t=>t.toFixed(4))} )`;switch(Ke.getTransfer(n)){case $r:return[e,"LinearTransferOETF"];case rt:return[e,"sRGBTransferOETF"];default:return Ce("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Zp(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+pb(n.getShaderSource(e),a)}else return r}function gb(n,e){let t=mb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var _b={[Xh]:"Linear",[qh]:"Reinhard",[Yh]:"Cineon",[Zh]:"ACESFilmic",[jh]:"AgX",[Jh]:"Neutral",[$h]:"Custom"};function vb(n,e){let t=_b[e];return t===void 0?(Ce("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var rc=new P;function yb(){Ke.getLuminanceCoefficients(rc);let n=rc.x.toFixed(4),e=rc.y.toFixed(4),t=rc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Po).join(`
`)}function bb(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Sb(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Po(n){return n!==""}function $p(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function jp(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Mb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mu(n){return n.replace(Mb,wb)}function wb(n,e){let t=He[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Mu(t)}var Tb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Jp(n){return n.replace(Tb,Eb)}function Eb(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Kp(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Ab={[xs]:"SHADOWMAP_TYPE_PCF",[ur]:"SHADOWMAP_TYPE_VSM"};function Rb(n){return Ab[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Cb={[fr]:"ENVMAP_MODE_REFRACTION"};function Pb(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Cb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Ib={[gl]:"ENVMAP_BLENDING_MULTIPLY",[pp]:"ENVMAP_BLENDING_MIX",[mp]:"ENVMAP_BLENDING_ADD"};function Lb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Ib[n.combine]||"ENVMAP_BLENDING_NONE"}function Db(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=Rb(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Pb(t),f=Lb(t),d=xb(t),u=bb(r),_=s.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,u].filter(Po).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,u].filter(Po).join(`
`),m.length>0&&(m+=`
`)):(b=[Kp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,u,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Po).join(`
`),m=[Kp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,u,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Vn?"#define TONE_MAPPING":"",t.toneMapping!==Vn?He.tonemapping_pars_fragment:"",t.toneMapping!==Vn?vb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",He.colorspace_pars_fragment,gb("linearToOutputTexel",t.outputColorSpace),yb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Po).join(`
`)),o=Mu(o),o=$p(o,t),o=jp(o,t),a=Mu(a),a=$p(a,t),a=jp(a,t),o=Jp(o),a=Jp(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===lu?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===lu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let S=g+b+o,E=g+m+a,M=qp(s,s.VERTEX_SHADER,S),C=qp(s,s.FRAGMENT_SHADER,E);s.attachShader(_,M),s.attachShader(_,C),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function R(N){if(n.debug.checkShaderErrors){let O=s.getProgramInfoLog(_)||"",G=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(C)||"",D=O.trim(),Y=G.trim(),K=W.trim(),H=!0,ie=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,M,C);else{let q=Zp(s,M,"vertex"),ee=Zp(s,C,"fragment");De("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+q+`
`+ee)}else D!==""?Ce("WebGLProgram: Program Info Log:",D):(Y===""||K==="")&&(ie=!1);ie&&(N.diagnostics={runnable:H,programLog:D,vertexShader:{log:Y,prefix:b},fragmentShader:{log:K,prefix:m}})}s.deleteShader(M),s.deleteShader(C),v=new _r(s,_),w=Sb(s,_)}let v;this.getUniforms=function(){return v===void 0&&R(this),v};let w;this.getAttributes=function(){return w===void 0&&R(this),w};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(_,db)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=fb++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=M,this.fragmentShader=C,this}var Nb=0,wu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Tu(e),t.set(e,i)),i}},Tu=class{constructor(e){this.id=Nb++,this.code=e,this.usedTimes=0}};function Ub(n){return n===Ki||n===Ao||n===Ro}function Ob(n,e,t,i,s,r){let o=new or,a=new wu,c=new Set,l=[],h=new Map,f=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function u(v){return c.add(v),v===0?"uv":`uv${v}`}function _(v,w,B,N,O,G){let W=N.fog,D=O.geometry,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,K=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||Y,K),ie=d[v.type],q=i.precision;v.precision!==null&&(q=i.getMaxPrecision(v.precision),q!==v.precision&&Ce("WebGLProgram.getParameters:",v.precision,"not supported, using",q,"instead."));let ee=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,te=ee!==void 0?ee.length:0,Te=0;D.morphAttributes.position!==void 0&&(Te=1),D.morphAttributes.normal!==void 0&&(Te=2),D.morphAttributes.color!==void 0&&(Te=3);let Fe,j,ge,be;if(ie){let pe=oi[ie];Fe=pe.vertexShader,j=pe.fragmentShader}else{Fe=v.vertexShader,j=v.fragmentShader;let pe=a.getVertexShaderStage(v),at=a.getFragmentShaderStage(v);a.update(v,pe,at),ge=pe.id,be=at.id}let Pe=n.getRenderTarget(),_e=n.state.buffers.depth.getReversed(),ke=O.isInstancedMesh===!0,Pt=O.isBatchedMesh===!0,Le=!!v.map,ot=!!v.matcap,ut=!!H,$e=ut&&H.isPMREMTexture===!0,tn=!!v.aoMap,Ft=!!v.lightMap,xn=!!v.bumpMap&&v.wireframe===!1,St=!!v.normalMap,ni=!!v.displacementMap,Zt=!!v.emissiveMap,Nn=!!v.metalnessMap,Un=!!v.roughnessMap,On=v.anisotropy>0,U=v.clearcoat>0,Fn=v.diffuseRoughness>0,vt=v.dispersion>0,yt=v.retroreflectivity>0,fe=v.iridescence>0,Bt=v.sheen>0,Ie=v.transmission>0,Ue=On&&!!v.anisotropyMap,T=U&&!!v.clearcoatMap,y=U&&!!v.clearcoatNormalMap,k=U&&!!v.clearcoatRoughnessMap,ne=Fn&&!!v.diffuseRoughnessMap,Q=fe&&!!v.iridescenceMap,oe=fe&&!!v.iridescenceThicknessMap,ue=Bt&&!!v.sheenColorMap,Z=Bt&&!!v.sheenRoughnessMap,$=!!v.specularMap,le=!!v.specularColorMap,I=!!v.specularIntensityMap,J=Ie&&!!v.transmissionMap,X=Ie&&!!v.thicknessMap,ce=!!v.gradientMap,re=!!v.alphaMap,ae=v.alphaTest>0,Ae=!!v.alphaHash,Ge=!!v.extensions,se=Vn;v.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(se=n.toneMapping);let Re=$e?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ze={shaderID:ie,shaderType:v.type,shaderName:v.name,vertexShader:Fe,fragmentShader:j,defines:v.defines,customVertexShaderID:ge,customFragmentShaderID:be,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:q,batching:Pt,batchingColor:Pt&&O._colorsTexture!==null,instancing:ke,instancingColor:ke&&O.instanceColor!==null,instancingMorph:ke&&O.morphTexture!==null,outputColorSpace:Pe===null?n.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:Ke.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Le,matcap:ot,envMap:ut,envMapMode:ut&&H.mapping,envMapPMREM:$e,envMapMaxLod:$e?Re.length-1:null,envMapSize:$e?Re[0].width:null,aoMap:tn,lightMap:Ft,bumpMap:xn,normalMap:St,displacementMap:ni,emissiveMap:Zt,normalMapObjectSpace:St&&v.normalMapType===vp,normalMapTangentSpace:St&&v.normalMapType===ic,packedNormalMap:St&&v.normalMapType===ic&&Ub(v.normalMap.format),metalnessMap:Nn,roughnessMap:Un,anisotropy:On,anisotropyMap:Ue,clearcoat:U,clearcoatMap:T,clearcoatNormalMap:y,clearcoatRoughnessMap:k,diffuseRoughness:Fn,diffuseRoughnessMap:ne,dispersion:vt,retroreflection:yt,iridescence:fe,iridescenceMap:Q,iridescenceThicknessMap:oe,sheen:Bt,sheenColorMap:ue,sheenRoughnessMap:Z,specularMap:$,specularColorMap:le,specularIntensityMap:I,transmission:Ie,transmissionMap:J,thicknessMap:X,gradientMap:ce,opaque:v.transparent===!1&&v.blending===dr&&v.alphaToCoverage===!1,alphaMap:re,alphaTest:ae,alphaHash:Ae,combine:v.combine,mapUv:Le&&u(v.map.channel),aoMapUv:tn&&u(v.aoMap.channel),lightMapUv:Ft&&u(v.lightMap.channel),bumpMapUv:xn&&u(v.bumpMap.channel),normalMapUv:St&&u(v.normalMap.channel),displacementMapUv:ni&&u(v.displacementMap.channel),emissiveMapUv:Zt&&u(v.emissiveMap.channel),metalnessMapUv:Nn&&u(v.metalnessMap.channel),roughnessMapUv:Un&&u(v.roughnessMap.channel),anisotropyMapUv:Ue&&u(v.anisotropyMap.channel),clearcoatMapUv:T&&u(v.clearcoatMap.channel),clearcoatNormalMapUv:y&&u(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&u(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&u(v.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&u(v.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&u(v.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&u(v.sheenColorMap.channel),sheenRoughnessMapUv:Z&&u(v.sheenRoughnessMap.channel),specularMapUv:$&&u(v.specularMap.channel),specularColorMapUv:le&&u(v.specularColorMap.channel),specularIntensityMapUv:I&&u(v.specularIntensityMap.channel),transmissionMapUv:J&&u(v.transmissionMap.channel),thicknessMapUv:X&&u(v.thicknessMap.channel),alphaMapUv:re&&u(v.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(St||On),vertexNormals:!!D.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!D.attributes.uv&&(Le||re),fog:!!W,useFog:v.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||D.attributes.normal===void 0&&St===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:_e,skinning:O.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:Te,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:G.filter(pe=>pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:se,decodeVideoTexture:Le&&v.map.isVideoTexture===!0&&Ke.getTransfer(v.map.colorSpace)===rt,decodeVideoTextureEmissive:Zt&&v.emissiveMap.isVideoTexture===!0&&Ke.getTransfer(v.emissiveMap.colorSpace)===rt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===yn,flipSided:v.side===vn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ge&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ge&&v.extensions.multiDraw===!0||Pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return ze.vertexUv1s=c.has(1),ze.vertexUv2s=c.has(2),ze.vertexUv3s=c.has(3),c.clear(),ze}function b(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let B in v.defines)w.push(B),w.push(v.defines[B]);return v.isRawShaderMaterial===!1&&(m(w,v),g(w,v),w.push(n.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function m(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function g(v,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function S(v){let w=d[v.type],B;if(w){let N=oi[w];B=Dp.clone(N.uniforms)}else B=v.uniforms;return B}function E(v,w){let B=h.get(w);return B!==void 0?++B.usedTimes:(B=new Db(n,w,v,s),l.push(B),h.set(w,B)),B}function M(v){if(--v.usedTimes===0){let w=l.indexOf(v);l[w]=l[l.length-1],l.pop(),h.delete(v.cacheKey),v.destroy()}}function C(v){a.remove(v)}function R(){a.dispose()}return{getParameters:_,getProgramCacheKey:b,getUniforms:S,acquireProgram:E,releaseProgram:M,releaseShaderCache:C,programs:l,dispose:R}}function Fb(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Bb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Qp(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function em(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let u=0;return d.isInstancedMesh&&(u+=2),d.isSkinnedMesh&&(u+=1),u}function a(d,u,_,b,m,g){let S=n[e];return S===void 0?(S={id:d.id,object:d,geometry:u,material:_,materialVariant:o(d),groupOrder:b,renderOrder:d.renderOrder,z:m,group:g},n[e]=S):(S.id=d.id,S.object=d,S.geometry=u,S.material=_,S.materialVariant=o(d),S.groupOrder=b,S.renderOrder=d.renderOrder,S.z=m,S.group=g),e++,S}function c(d,u,_,b,m,g,S){S.reversedDepth===!0&&(m=-m);let E=a(d,u,_,b,m,g);_.transmission>0?i.push(E):_.transparent===!0?s.push(E):t.push(E)}function l(d,u,_,b,m,g){let S=a(d,u,_,b,m,g);_.transmission>0?i.unshift(S):_.transparent===!0?s.unshift(S):t.unshift(S)}function h(d,u){t.length>1&&t.sort(d||Bb),i.length>1&&i.sort(u||Qp),s.length>1&&s.sort(u||Qp)}function f(){for(let d=e,u=n.length;d<u;d++){let _=n[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function kb(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new em,n.set(i,[o])):s>=r.length?(o=new em,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function zb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new P,color:new Oe};break;case"SpotLight":t={position:new P,direction:new P,color:new Oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new Oe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new Oe,groundColor:new Oe};break;case"RectAreaLight":t={color:new Oe,position:new P,halfWidth:new P,halfHeight:new P};break}return n[e.id]=t,t}}}function Gb(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ye};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ye};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ye,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var Vb=0;function Hb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Wb(n){let e=new zb,t=Gb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new P);let s=new P,r=new qe,o=new qe;function a(l){let h=0,f=0,d=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let u=0,_=0,b=0,m=0,g=0,S=0,E=0,M=0,C=0,R=0,v=0,w=0,B=0,N=0;l.sort(Hb);for(let G=0,W=l.length;G<W;G++){let D=l[G],Y=D.color,K=D.intensity,H=D.distance,ie=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ki?ie=D.shadow.map.texture:ie=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=Y.r*K,f+=Y.g*K,d+=Y.b*K;else if(D.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(D.sh.coefficients[q],K);N++}else if(D.isSunLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ee=D.shadow,te=t.get(D);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),i.sunShadow[_]=te,i.sunShadowMap[_]=ie;let Te=ee.getViewportCount();for(let Fe=0;Fe<Te;Fe++)i.sunShadowMatrix[b+Fe]=ee.getMatrix(Fe),i.sunShadowCascade[b+Fe]=ee._cascadeData[Fe];b+=Te,_++}i.sun[u]=q,u++}else if(D.isDirectionalLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ee=D.shadow,te=t.get(D);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,i.directionalShadow[m]=te,i.directionalShadowMap[m]=ie,i.directionalShadowMatrix[m]=D.shadow.matrix,C++}i.directional[m]=q,m++}else if(D.isSpotLight){let q=e.get(D);q.position.setFromMatrixPosition(D.matrixWorld),q.color.copy(Y).multiplyScalar(K),q.distance=H,q.coneCos=Math.cos(D.angle),q.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),q.decay=D.decay,i.spot[S]=q;let ee=D.shadow;if(D.map&&(i.spotLightMap[w]=D.map,w++,ee.updateMatrices(D),D.castShadow&&B++),i.spotLightMatrix[S]=ee.matrix,D.castShadow){let te=t.get(D);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,i.spotShadow[S]=te,i.spotShadowMap[S]=ie,v++}S++}else if(D.isRectAreaLight){let q=e.get(D);q.color.copy(Y).multiplyScalar(K),q.halfWidth.set(D.width*.5,0,0),q.halfHeight.set(0,D.height*.5,0),i.rectArea[E]=q,E++}else if(D.isPointLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),q.distance=D.distance,q.decay=D.decay,D.castShadow){let ee=D.shadow,te=t.get(D);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,te.shadowCameraNear=ee.camera.near,te.shadowCameraFar=ee.camera.far,i.pointShadow[g]=te,i.pointShadowMap[g]=ie,i.pointShadowMatrix[g]=D.shadow.matrix,R++}i.point[g]=q,g++}else if(D.isHemisphereLight){let q=e.get(D);q.skyColor.copy(D.color).multiplyScalar(K),q.groundColor.copy(D.groundColor).multiplyScalar(K),i.hemi[M]=q,M++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=me.LTC_FLOAT_1,i.rectAreaLTC2=me.LTC_FLOAT_2):(i.rectAreaLTC1=me.LTC_HALF_1,i.rectAreaLTC2=me.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=d;let O=i.hash;(O.sunLength!==u||O.directionalLength!==m||O.pointLength!==g||O.spotLength!==S||O.rectAreaLength!==E||O.hemiLength!==M||O.numSunShadows!==_||O.numDirectionalShadows!==C||O.numPointShadows!==R||O.numSpotShadows!==v||O.numSpotMaps!==w||O.numLightProbes!==N)&&(i.sun.length=u,i.directional.length=m,i.spot.length=S,i.rectArea.length=E,i.point.length=g,i.hemi.length=M,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=R,i.pointShadowMap.length=R,i.pointShadowMatrix.length=R,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+w-B,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=N,O.sunLength=u,O.directionalLength=m,O.pointLength=g,O.spotLength=S,O.rectAreaLength=E,O.hemiLength=M,O.numSunShadows=_,O.numDirectionalShadows=C,O.numPointShadows=R,O.numSpotShadows=v,O.numSpotMaps=w,O.numLightProbes=N,i.version=Vb++)}function c(l,h){let f=0,d=0,u=0,_=0,b=0,m=0,g=h.matrixWorldInverse;for(let S=0,E=l.length;S<E;S++){let M=l[S];if(M.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(g),f++}else if(M.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(M.isSpotLight){let C=i.spot[_];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),_++}else if(M.isRectAreaLight){let C=i.rectArea[b];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(M.width*.5,0,0),C.halfHeight.set(0,M.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),b++}else if(M.isPointLight){let C=i.point[u];C.position.setFromMatrixPosition(M.matrixWorld),C.position.applyMatrix4(g),u++}else if(M.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(M.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:i}}function tm(n){let e=new Wb(n),t=[],i=[],s=[];function r(f){h.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function c(){e.setup(t),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function Xb(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new tm(n),e.set(s,[a])):r>=o.length?(a=new tm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var qb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Yb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Zb=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],$b=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],nm=new qe,Co=new P,yu=new P;function jb(n,e,t){let i=new Vi,s=new ye,r=new ye,o=new bt,a=new nl,c=new il,l={},h=t.maxTextureSize,f={[Ji]:vn,[vn]:Ji,[yn]:yn},d=new Gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ye},radius:{value:4}},vertexShader:qb,fragmentShader:Yb}),u=d.clone();u.defines.HORIZONTAL_PASS=1;let _=new Sn;_.setAttribute("position",new Pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new mt(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=xs;let g=this.type;this.render=function(R,v,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===$f&&(Ce("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=xs);let B=n.getRenderTarget(),N=n.getActiveCubeFace(),O=n.getActiveMipmapLevel(),G=n.state;G.setBlending(bs),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=g!==this.type;W&&v.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(Y=>Y.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,Y=R.length;D<Y;D++){let K=R[D],H=K.shadow;if(H===void 0){Ce("WebGLShadowMap:",K,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ie=H.getFrameExtents();s.multiply(ie),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ie.x),s.x=r.x*ie.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ie.y),s.y=r.y*ie.y,H.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=q,H.map===null||W===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===ur){if(K.isPointLight){Ce("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new In(s.x,s.y,{format:Ki,type:Jn,minFilter:gn,magFilter:gn,generateMipmaps:!1}),H.map.texture.name=K.name+".shadowMap",H.map.depthTexture=new Mi(s.x,s.y,Hn),H.map.depthTexture.name=K.name+".shadowMapDepth",H.map.depthTexture.format=vi,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Qt,H.map.depthTexture.magFilter=Qt}else K.isPointLight?(H.map=new Io(s.x),H.map.depthTexture=new oo(s.x,jn)):(H.map=new In(s.x,s.y),H.map.depthTexture=new Mi(s.x,s.y,jn)),H.map.depthTexture.name=K.name+".shadowMap",H.map.depthTexture.format=vi,this.type===xs?(H.map.depthTexture.compareFunction=q?ou:ru,H.map.depthTexture.minFilter=gn,H.map.depthTexture.magFilter=gn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Qt,H.map.depthTexture.magFilter=Qt);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let ee=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();K.isPointLight!==!0&&H.updateMatrices(K,w);let te=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:w.layers;for(let Te=0;Te<ee;Te++){let Fe=H.getCamera(Te);if(K.isPointLight){let j=H.camera,ge=H.matrix,be=K.distance||j.far;be!==j.far&&(j.far=be,j.updateProjectionMatrix()),Co.setFromMatrixPosition(K.matrixWorld),j.position.copy(Co),yu.copy(j.position),yu.add(Zb[Te]),j.up.copy($b[Te]),j.lookAt(yu),j.updateMatrixWorld(),ge.makeTranslation(-Co.x,-Co.y,-Co.z),nm.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),H._frustum.setFromProjectionMatrix(nm,j.coordinateSystem,j.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,Te),n.clear();else{Te===0&&(n.setRenderTarget(H.map),n.clear());let j=H.getViewport(Te);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),G.viewport(o)}i=H.getFrustum(Te),M(v,w,Fe,K,te,this.type)}H.isPointLightShadow!==!0&&this.type===ur&&S(H,w),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(B,N,O)};function S(R,v){let w=e.update(b);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,u.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,u.needsUpdate=!0),R.mapPass===null?R.mapPass=new In(s.x,s.y,{format:Ki,type:Jn}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),d.uniforms.shadow_pass.value=R.map.depthTexture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(v,null,w,d,b,null),u.uniforms.shadow_pass.value=R.mapPass.texture,u.uniforms.resolution.value.set(R.map.width,R.map.height),u.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(v,null,w,u,b,null)}function E(R,v,w,B){let N=null,O=w.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(O!==void 0)N=O;else if(N=w.isPointLight===!0?c:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let G=N.uuid,W=v.uuid,D=l[G];D===void 0&&(D={},l[G]=D);let Y=D[W];Y===void 0&&(Y=N.clone(),D[W]=Y,v.addEventListener("dispose",C)),N=Y}if(N.visible=v.visible,N.wireframe=v.wireframe,B===ur?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:f[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,w.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let G=n.properties.get(N);G.light=w}return N}function M(R,v,w,B,N,O){if(R.visible===!1)return;if(R.layers.test(N)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&O===ur)&&(!R.frustumCulled||R.intersectsFrustum(i))){R.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,R.matrixWorld);let D=e.update(R),Y=R.material;if(Array.isArray(Y)){let K=D.groups;for(let H=0,ie=K.length;H<ie;H++){let q=K[H],ee=Y[q.materialIndex];if(ee&&ee.visible){let te=E(R,ee,B,O);R.onBeforeShadow(n,R,v,w,D,te,q),n.renderBufferDirect(w,null,D,te,R,q),R.onAfterShadow(n,R,v,w,D,te,q)}}}else if(Y.visible){let K=E(R,Y,B,O);R.onBeforeShadow(n,R,v,w,D,K,null),n.renderBufferDirect(w,null,D,K,R,null),R.onAfterShadow(n,R,v,w,D,K,null)}}let W=R.children;for(let D=0,Y=W.length;D<Y;D++)M(W[D],v,w,B,N,O)}function C(R){R.target.removeEventListener("dispose",C);for(let w in l){let B=l[w],N=R.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function Jb(n,e){function t(){let I=!1,J=new bt,X=null,ce=new bt(0,0,0,0);return{setMask:function(re){X!==re&&!I&&(n.colorMask(re,re,re,re),X=re)},setLocked:function(re){I=re},setClear:function(re,ae,Ae,Ge,se){se===!0&&(re*=Ge,ae*=Ge,Ae*=Ge),J.set(re,ae,Ae,Ge),ce.equals(J)===!1&&(n.clearColor(re,ae,Ae,Ge),ce.copy(J))},reset:function(){I=!1,X=null,ce.set(-1,0,0,0)}}}function i(){let I=!1,J=!1,X=null,ce=null,re=null;return{setReversed:function(ae){if(J!==ae){let Ae=e.get("EXT_clip_control");ae?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),J=ae;let Ge=re;re=null,this.setClear(Ge)}},getReversed:function(){return J},setTest:function(ae){ae?_e(n.DEPTH_TEST):ke(n.DEPTH_TEST)},setMask:function(ae){X!==ae&&!I&&(n.depthMask(ae),X=ae)},setFunc:function(ae){if(J&&(ae=Cp[ae]),ce!==ae){switch(ae){case La:n.depthFunc(n.NEVER);break;case Da:n.depthFunc(n.ALWAYS);break;case Na:n.depthFunc(n.LESS);break;case er:n.depthFunc(n.LEQUAL);break;case Ua:n.depthFunc(n.EQUAL);break;case Oa:n.depthFunc(n.GEQUAL);break;case Fa:n.depthFunc(n.GREATER);break;case Ba:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}ce=ae}},setLocked:function(ae){I=ae},setClear:function(ae){re!==ae&&(re=ae,J&&(ae=1-ae),n.clearDepth(ae))},reset:function(){I=!1,X=null,ce=null,re=null,J=!1}}}function s(){let I=!1,J=null,X=null,ce=null,re=null,ae=null,Ae=null,Ge=null,se=null;return{setTest:function(Re){I||(Re?_e(n.STENCIL_TEST):ke(n.STENCIL_TEST))},setMask:function(Re){J!==Re&&!I&&(n.stencilMask(Re),J=Re)},setFunc:function(Re,ze,pe){(X!==Re||ce!==ze||re!==pe)&&(n.stencilFunc(Re,ze,pe),X=Re,ce=ze,re=pe)},setOp:function(Re,ze,pe){(ae!==Re||Ae!==ze||Ge!==pe)&&(n.stencilOp(Re,ze,pe),ae=Re,Ae=ze,Ge=pe)},setLocked:function(Re){I=Re},setClear:function(Re){se!==Re&&(n.clearStencil(Re),se=Re)},reset:function(){I=!1,J=null,X=null,ce=null,re=null,ae=null,Ae=null,Ge=null,se=null}}}let r=new t,o=new i,a=new s,c={},l=new WeakMap,h={},f={},d={},u=new WeakMap,_=[],b=null,m=!1,g=null,S=null,E=null,M=null,C=null,R=null,v=null,w=new Oe(0,0,0),B=0,N=!1,O=null,G=null,W=null,D=null,Y=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ie=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(q)[1]),H=ie>=1):q.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),H=ie>=2);let ee=null,te={},Te=n.getParameter(n.SCISSOR_BOX),Fe=n.getParameter(n.VIEWPORT),j=new bt().fromArray(Te),ge=new bt().fromArray(Fe);function be(I,J,X,ce){let re=new Uint8Array(4),ae=n.createTexture();n.bindTexture(I,ae),n.texParameteri(I,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(I,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ae=0;Ae<X;Ae++)I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,ce,0,n.RGBA,n.UNSIGNED_BYTE,re):n.texImage2D(J+Ae,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,re);return ae}let Pe={};Pe[n.TEXTURE_2D]=be(n.TEXTURE_2D,n.TEXTURE_2D,1),Pe[n.TEXTURE_CUBE_MAP]=be(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[n.TEXTURE_2D_ARRAY]=be(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pe[n.TEXTURE_3D]=be(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_e(n.DEPTH_TEST),o.setFunc(er),xn(!1),St(kh),_e(n.CULL_FACE),tn(bs);function _e(I){h[I]!==!0&&(n.enable(I),h[I]=!0)}function ke(I){h[I]!==!1&&(n.disable(I),h[I]=!1)}function Pt(I,J){return d[I]!==J?(n.bindFramebuffer(I,J),d[I]=J,I===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=J),I===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Le(I,J){let X=_,ce=!1;if(I){X=u.get(J),X===void 0&&(X=[],u.set(J,X));let re=I.textures;if(X.length!==re.length||X[0]!==n.COLOR_ATTACHMENT0){for(let ae=0,Ae=re.length;ae<Ae;ae++)X[ae]=n.COLOR_ATTACHMENT0+ae;X.length=re.length,ce=!0}}else X[0]!==n.BACK&&(X[0]=n.BACK,ce=!0);ce&&n.drawBuffers(X)}function ot(I){return b!==I?(n.useProgram(I),b=I,!0):!1}let ut={[Ss]:n.FUNC_ADD,[Jf]:n.FUNC_SUBTRACT,[Kf]:n.FUNC_REVERSE_SUBTRACT};ut[Qf]=n.MIN,ut[ep]=n.MAX;let $e={[tp]:n.ZERO,[np]:n.ONE,[ip]:n.SRC_COLOR,[Hh]:n.SRC_ALPHA,[cp]:n.SRC_ALPHA_SATURATE,[ap]:n.DST_COLOR,[rp]:n.DST_ALPHA,[sp]:n.ONE_MINUS_SRC_COLOR,[Wh]:n.ONE_MINUS_SRC_ALPHA,[lp]:n.ONE_MINUS_DST_COLOR,[op]:n.ONE_MINUS_DST_ALPHA,[hp]:n.CONSTANT_COLOR,[up]:n.ONE_MINUS_CONSTANT_COLOR,[dp]:n.CONSTANT_ALPHA,[fp]:n.ONE_MINUS_CONSTANT_ALPHA};function tn(I,J,X,ce,re,ae,Ae,Ge,se,Re){if(I===bs){m===!0&&(ke(n.BLEND),m=!1);return}if(m===!1&&(_e(n.BLEND),m=!0),I!==jf){if(I!==g||Re!==N){if((S!==Ss||C!==Ss)&&(n.blendEquation(n.FUNC_ADD),S=Ss,C=Ss),Re)switch(I){case dr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zh:n.blendFunc(n.ONE,n.ONE);break;case Gh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Vh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:De("WebGLState: Invalid blending: ",I);break}else switch(I){case dr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Gh:De("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vh:De("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:De("WebGLState: Invalid blending: ",I);break}E=null,M=null,R=null,v=null,w.set(0,0,0),B=0,g=I,N=Re}return}re=re||J,ae=ae||X,Ae=Ae||ce,(J!==S||re!==C)&&(n.blendEquationSeparate(ut[J],ut[re]),S=J,C=re),(X!==E||ce!==M||ae!==R||Ae!==v)&&(n.blendFuncSeparate($e[X],$e[ce],$e[ae],$e[Ae]),E=X,M=ce,R=ae,v=Ae),(Ge.equals(w)===!1||se!==B)&&(n.blendColor(Ge.r,Ge.g,Ge.b,se),w.copy(Ge),B=se),g=I,N=!1}function Ft(I,J){I.side===yn?ke(n.CULL_FACE):_e(n.CULL_FACE);let X=I.side===vn;J&&(X=!X),xn(X),I.blending===dr&&I.transparent===!1?tn(bs):tn(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),o.setFunc(I.depthFunc),o.setTest(I.depthTest),o.setMask(I.depthWrite),r.setMask(I.colorWrite);let ce=I.stencilWrite;a.setTest(ce),ce&&(a.setMask(I.stencilWriteMask),a.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),a.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Zt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?_e(n.SAMPLE_ALPHA_TO_COVERAGE):ke(n.SAMPLE_ALPHA_TO_COVERAGE)}function xn(I){O!==I&&(I?n.frontFace(n.CW):n.frontFace(n.CCW),O=I)}function St(I){I!==Yf?(_e(n.CULL_FACE),I!==G&&(I===kh?n.cullFace(n.BACK):I===Zf?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):ke(n.CULL_FACE),G=I}function ni(I){I!==W&&(H&&n.lineWidth(I),W=I)}function Zt(I,J,X){I?(_e(n.POLYGON_OFFSET_FILL),(D!==J||Y!==X)&&(D=J,Y=X,o.getReversed()&&(J=-J,X=-X),n.polygonOffset(J,X))):ke(n.POLYGON_OFFSET_FILL)}function Nn(I){I?_e(n.SCISSOR_TEST):ke(n.SCISSOR_TEST)}function Un(I){I===void 0&&(I=n.TEXTURE0+K-1),ee!==I&&(n.activeTexture(I),ee=I)}function On(I,J,X){X===void 0&&(ee===null?X=n.TEXTURE0+K-1:X=ee);let ce=te[X];ce===void 0&&(ce={type:void 0,texture:void 0},te[X]=ce),(ce.type!==I||ce.texture!==J)&&(ee!==X&&(n.activeTexture(X),ee=X),n.bindTexture(I,J||Pe[I]),ce.type=I,ce.texture=J)}function U(){let I=te[ee];I!==void 0&&I.type!==void 0&&(n.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function Fn(){try{n.compressedTexImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function vt(){try{n.compressedTexImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function yt(){try{n.texSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function fe(){try{n.texSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function Bt(){try{n.compressedTexSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function Ie(){try{n.compressedTexSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function Ue(){try{n.texStorage2D(...arguments)}catch(I){De("WebGLState:",I)}}function T(){try{n.texStorage3D(...arguments)}catch(I){De("WebGLState:",I)}}function y(){try{n.texImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function k(){try{n.texImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function ne(I){return f[I]!==void 0?f[I]:n.getParameter(I)}function Q(I,J){f[I]!==J&&(n.pixelStorei(I,J),f[I]=J)}function oe(I){j.equals(I)===!1&&(n.scissor(I.x,I.y,I.z,I.w),j.copy(I))}function ue(I){ge.equals(I)===!1&&(n.viewport(I.x,I.y,I.z,I.w),ge.copy(I))}function Z(I,J){let X=l.get(J);X===void 0&&(X=new WeakMap,l.set(J,X));let ce=X.get(I);ce===void 0&&(ce=n.getUniformBlockIndex(J,I.name),n.uniformBlockBinding(J,ce,ce),X.set(I,ce))}function $(I,J,X){let re=l.get(J).get(I);c[re]!==X&&(n.bindBufferBase(n.UNIFORM_BUFFER,re,X),c[re]=X)}function le(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},ee=null,te={},d={},c={},u=new WeakMap,_=[],b=null,m=!1,g=null,S=null,E=null,M=null,C=null,R=null,v=null,w=new Oe(0,0,0),B=0,N=!1,O=null,G=null,W=null,D=null,Y=null,j.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_e,disable:ke,bindFramebuffer:Pt,drawBuffers:Le,useProgram:ot,setBlending:tn,setMaterial:Ft,setFlipSided:xn,setCullFace:St,setLineWidth:ni,setPolygonOffset:Zt,setScissorTest:Nn,activeTexture:Un,bindTexture:On,unbindTexture:U,compressedTexImage2D:Fn,compressedTexImage3D:vt,texImage2D:y,texImage3D:k,pixelStorei:Q,getParameter:ne,updateUBOMapping:Z,uniformBlockBinding:$,texStorage2D:Ue,texStorage3D:T,texSubImage2D:yt,texSubImage3D:fe,compressedTexSubImage2D:Bt,compressedTexSubImage3D:Ie,scissor:oe,viewport:ue,reset:le}}function Kb(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new ye,h=new WeakMap,f=new Set,d,u=new WeakMap,_=new Set,b=new FinalizationRegistry(T=>_.delete(T)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(T,y){return m?new OffscreenCanvas(T,y):jr("canvas")}function S(T,y,k){let ne=1,Q=Ue(T);if((Q.width>k||Q.height>k)&&(ne=k/Math.max(Q.width,Q.height)),ne<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let oe=Math.floor(ne*Q.width),ue=Math.floor(ne*Q.height);d===void 0&&(d=g(oe,ue));let Z=y?g(oe,ue):d;return Z.width=oe,Z.height=ue,Z.getContext("2d").drawImage(T,0,0,oe,ue),Ce("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+oe+"x"+ue+")."),Z}else return"data"in T&&Ce("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),T;return T}function E(T){return T.generateMipmaps}function M(T){n.generateMipmap(T)}function C(T){return T.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?n.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function R(T,y,k,ne,Q,oe=!1){if(T!==null){if(n[T]!==void 0)return n[T];Ce("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Ce("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=y;if(y===n.RED&&(k===n.FLOAT&&(Z=n.R32F),k===n.HALF_FLOAT&&(Z=n.R16F),k===n.UNSIGNED_BYTE&&(Z=n.R8),k===n.UNSIGNED_SHORT&&ue&&(Z=ue.R16_EXT),k===n.SHORT&&ue&&(Z=ue.R16_SNORM_EXT)),y===n.RED_INTEGER&&(k===n.UNSIGNED_BYTE&&(Z=n.R8UI),k===n.UNSIGNED_SHORT&&(Z=n.R16UI),k===n.UNSIGNED_INT&&(Z=n.R32UI),k===n.BYTE&&(Z=n.R8I),k===n.SHORT&&(Z=n.R16I),k===n.INT&&(Z=n.R32I)),y===n.RG&&(k===n.FLOAT&&(Z=n.RG32F),k===n.HALF_FLOAT&&(Z=n.RG16F),k===n.UNSIGNED_BYTE&&(Z=n.RG8),k===n.UNSIGNED_SHORT&&ue&&(Z=ue.RG16_EXT),k===n.SHORT&&ue&&(Z=ue.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(k===n.UNSIGNED_BYTE&&(Z=n.RG8UI),k===n.UNSIGNED_SHORT&&(Z=n.RG16UI),k===n.UNSIGNED_INT&&(Z=n.RG32UI),k===n.BYTE&&(Z=n.RG8I),k===n.SHORT&&(Z=n.RG16I),k===n.INT&&(Z=n.RG32I)),y===n.RGB_INTEGER&&(k===n.UNSIGNED_BYTE&&(Z=n.RGB8UI),k===n.UNSIGNED_SHORT&&(Z=n.RGB16UI),k===n.UNSIGNED_INT&&(Z=n.RGB32UI),k===n.BYTE&&(Z=n.RGB8I),k===n.SHORT&&(Z=n.RGB16I),k===n.INT&&(Z=n.RGB32I)),y===n.RGBA_INTEGER&&(k===n.UNSIGNED_BYTE&&(Z=n.RGBA8UI),k===n.UNSIGNED_SHORT&&(Z=n.RGBA16UI),k===n.UNSIGNED_INT&&(Z=n.RGBA32UI),k===n.BYTE&&(Z=n.RGBA8I),k===n.SHORT&&(Z=n.RGBA16I),k===n.INT&&(Z=n.RGBA32I)),y===n.RGB&&(k===n.UNSIGNED_SHORT&&ue&&(Z=ue.RGB16_EXT),k===n.SHORT&&ue&&(Z=ue.RGB16_SNORM_EXT),k===n.UNSIGNED_INT_5_9_9_9_REV&&(Z=n.RGB9_E5),k===n.UNSIGNED_INT_10F_11F_11F_REV&&(Z=n.R11F_G11F_B10F)),y===n.RGBA){let $=oe?$r:Ke.getTransfer(Q);k===n.FLOAT&&(Z=n.RGBA32F),k===n.HALF_FLOAT&&(Z=n.RGBA16F),k===n.UNSIGNED_BYTE&&(Z=$===rt?n.SRGB8_ALPHA8:n.RGBA8),k===n.UNSIGNED_SHORT&&ue&&(Z=ue.RGBA16_EXT),k===n.SHORT&&ue&&(Z=ue.RGBA16_SNORM_EXT),k===n.UNSIGNED_SHORT_4_4_4_4&&(Z=n.RGBA4),k===n.UNSIGNED_SHORT_5_5_5_1&&(Z=n.RGB5_A1)}return(Z===n.R16F||Z===n.R32F||Z===n.RG16F||Z===n.RG32F||Z===n.RGBA16F||Z===n.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function v(T,y){let k;return T?y===null||y===jn||y===ws?k=n.DEPTH24_STENCIL8:y===Hn?k=n.DEPTH32F_STENCIL8:y===pr&&(k=n.DEPTH24_STENCIL8,Ce("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===jn||y===ws?k=n.DEPTH_COMPONENT24:y===Hn?k=n.DEPTH_COMPONENT32F:y===pr&&(k=n.DEPTH_COMPONENT16),k}function w(T,y){return E(T)===!0||T.isFramebufferTexture&&T.minFilter!==Qt&&T.minFilter!==gn?Math.log2(Math.max(y.width,y.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?y.mipmaps.length:1}function B(T){let y=new WeakRef(T);i.get(T).__ref=y,_.add(y),b.register(T,y,y)}function N(T){let y=i.get(T).__ref;y!==void 0&&(_.delete(y),b.unregister(y))}function O(T){W(T.target)}function G(T){D(T.target)}function W(T){T.removeEventListener("dispose",O),N(T),K(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&f.delete(T)}function D(T){T.removeEventListener("dispose",G),N(T),ie(T)}function Y(){for(let T of _){let y=T.deref();y!==void 0&&(y.isRenderTarget===!0?D(y):W(y))}_.clear(),f.clear()}function K(T){let y=i.get(T);if(y.__webglInit===void 0)return;let k=T.source,ne=u.get(k);if(ne){let Q=ne[y.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(T),Object.keys(ne).length===0&&u.delete(k)}i.remove(T)}function H(T){let y=i.get(T);n.deleteTexture(y.__webglTexture);let k=T.source,ne=u.get(k);delete ne[y.__cacheKey],o.memory.textures--}function ie(T){let y=i.get(T);y.__depthDisposeCallback&&y.__depthDisposeCallback();let k=T.depthTexture;if(k&&k.renderTarget===T&&W(k),T.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(y.__webglFramebuffer[Q]))for(let oe=0;oe<y.__webglFramebuffer[Q].length;oe++)n.deleteFramebuffer(y.__webglFramebuffer[Q][oe]);else n.deleteFramebuffer(y.__webglFramebuffer[Q]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[Q])}else{if(Array.isArray(y.__webglFramebuffer))for(let Q=0;Q<y.__webglFramebuffer.length;Q++)n.deleteFramebuffer(y.__webglFramebuffer[Q]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Q=0;Q<y.__webglColorRenderbuffer.length;Q++)y.__webglColorRenderbuffer[Q]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[Q]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let ne=T.textures;for(let Q=0,oe=ne.length;Q<oe;Q++){let ue=i.get(ne[Q]);ue.__webglTexture&&(n.deleteTexture(ue.__webglTexture),o.memory.textures--),i.remove(ne[Q])}i.remove(T)}let q=0;function ee(){q=0}function te(){return q}function Te(T){q=T}function Fe(){let T=q;return T>=s.maxTextures&&Ce("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,T}function j(T){let y=[];return y.push(T.wrapS),y.push(T.wrapT),y.push(T.wrapR||0),y.push(T.magFilter),y.push(T.minFilter),y.push(T.anisotropy),y.push(T.internalFormat),y.push(T.format),y.push(T.type),y.push(T.generateMipmaps),y.push(T.mipmapsAutoUpdate),y.push(T.premultiplyAlpha),y.push(T.flipY),y.push(T.unpackAlignment),y.push(T.colorSpace),y.join()}function ge(T,y){let k=i.get(T);if(T.isVideoTexture&&Bt(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&k.__version!==T.version){let ne=T.image;if(ne===null)Ce("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Ce("WebGLRenderer: Texture marked for update but image is incomplete");else{Ft(k,T,y);return}}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,k.__webglTexture,n.TEXTURE0+y)}function be(T,y){let k=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Ft(k,T,y);return}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,k.__webglTexture,n.TEXTURE0+y)}function Pe(T,y){let k=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Ft(k,T,y);return}t.bindTexture(n.TEXTURE_3D,k.__webglTexture,n.TEXTURE0+y)}function _e(T,y){let k=i.get(T);if(T.version>0&&k.__version!==T.version){xn(k,T,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,k.__webglTexture,n.TEXTURE0+y)}let ke={[tr]:n.REPEAT,[si]:n.CLAMP_TO_EDGE,[ka]:n.MIRRORED_REPEAT},Pt={[Qt]:n.NEAREST,[gp]:n.NEAREST_MIPMAP_NEAREST,[So]:n.NEAREST_MIPMAP_LINEAR,[gn]:n.LINEAR,[yl]:n.LINEAR_MIPMAP_NEAREST,[wi]:n.LINEAR_MIPMAP_LINEAR},Le={[xp]:n.NEVER,[au]:n.ALWAYS,[bp]:n.LESS,[ru]:n.LEQUAL,[Sp]:n.EQUAL,[ou]:n.GEQUAL,[Mp]:n.GREATER,[wp]:n.NOTEQUAL};function ot(T,y){if(y.type===Hn&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===gn||y.magFilter===yl||y.magFilter===So||y.magFilter===wi||y.minFilter===gn||y.minFilter===yl||y.minFilter===So||y.minFilter===wi)&&Ce("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(T,n.TEXTURE_WRAP_S,ke[y.wrapS]),n.texParameteri(T,n.TEXTURE_WRAP_T,ke[y.wrapT]),(T===n.TEXTURE_3D||T===n.TEXTURE_2D_ARRAY)&&n.texParameteri(T,n.TEXTURE_WRAP_R,ke[y.wrapR]),n.texParameteri(T,n.TEXTURE_MAG_FILTER,Pt[y.magFilter]),n.texParameteri(T,n.TEXTURE_MIN_FILTER,Pt[y.minFilter]),y.compareFunction&&(n.texParameteri(T,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(T,n.TEXTURE_COMPARE_FUNC,Le[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Qt||y.minFilter!==So&&y.minFilter!==wi||y.type===Hn&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let k=e.get("EXT_texture_filter_anisotropic");n.texParameterf(T,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ut(T,y){let k=!1;T.__webglInit===void 0&&(T.__webglInit=!0,y.addEventListener("dispose",O),B(y));let ne=y.source,Q=u.get(ne);Q===void 0&&(Q={},u.set(ne,Q));let oe=j(y);if(oe!==T.__cacheKey){Q[oe]===void 0&&(Q[oe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,k=!0),Q[oe].usedTimes++;let ue=Q[T.__cacheKey];ue!==void 0&&(Q[T.__cacheKey].usedTimes--,ue.usedTimes===0&&H(y)),T.__cacheKey=oe,T.__webglTexture=Q[oe].texture}return k}function $e(T,y,k){return Math.floor(Math.floor(T/k)/y)}function tn(T,y,k,ne){let oe=T.updateRanges;if(oe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,k,ne,y.data);else{oe.sort((I,J)=>I.start-J.start);let ue=0;for(let I=1;I<oe.length;I++){let J=oe[ue],X=oe[I],ce=J.start+J.count,re=$e(X.start,y.width,4),ae=$e(J.start,y.width,4);X.start<=ce+1&&re===ae&&$e(X.start+X.count-1,y.width,4)===re?J.count=Math.max(J.count,X.start+X.count-J.start):(++ue,oe[ue]=X)}oe.length=ue+1;let Z=t.getParameter(n.UNPACK_ROW_LENGTH),$=t.getParameter(n.UNPACK_SKIP_PIXELS),le=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let I=0,J=oe.length;I<J;I++){let X=oe[I],ce=Math.floor(X.start/4),re=Math.ceil(X.count/4),ae=ce%y.width,Ae=Math.floor(ce/y.width),Ge=re,se=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(n.TEXTURE_2D,0,ae,Ae,Ge,se,k,ne,y.data)}T.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,Z),t.pixelStorei(n.UNPACK_SKIP_PIXELS,$),t.pixelStorei(n.UNPACK_SKIP_ROWS,le)}}function Ft(T,y,k){let ne=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(ne=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(ne=n.TEXTURE_3D);let Q=ut(T,y),oe=y.source;t.bindTexture(ne,T.__webglTexture,n.TEXTURE0+k);let ue=i.get(oe);if(oe.version!==ue.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+k),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let se=Ke.getPrimaries(Ke.workingColorSpace),Re=y.colorSpace===Ei?null:Ke.getPrimaries(y.colorSpace),ze=y.colorSpace===Ei||se===Re?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ze)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let $=S(y.image,!1,s.maxTextureSize);$=Ie(y,$);let le=r.convert(y.format,y.colorSpace),I=r.convert(y.type),J=R(y.internalFormat,le,I,y.normalized,y.colorSpace,y.isVideoTexture);ot(ne,y);let X,ce=y.mipmaps,re=y.isVideoTexture!==!0,ae=ue.__version===void 0||Q===!0,Ae=oe.dataReady,Ge=w(y,$);if(y.isDepthTexture)J=v(y.format===Ti,y.type),ae&&(re?t.texStorage2D(n.TEXTURE_2D,1,J,$.width,$.height):t.texImage2D(n.TEXTURE_2D,0,J,$.width,$.height,0,le,I,null));else if(y.isDataTexture)if(ce.length>0){re&&ae&&t.texStorage2D(n.TEXTURE_2D,Ge,J,ce[0].width,ce[0].height);for(let se=0,Re=ce.length;se<Re;se++)X=ce[se],re?Ae&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,X.width,X.height,le,I,X.data):t.texImage2D(n.TEXTURE_2D,se,J,X.width,X.height,0,le,I,X.data);y.generateMipmaps=!1}else re?(ae&&t.texStorage2D(n.TEXTURE_2D,Ge,J,$.width,$.height),Ae&&tn(y,$,le,I)):t.texImage2D(n.TEXTURE_2D,0,J,$.width,$.height,0,le,I,$.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){re&&ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ge,J,ce[0].width,ce[0].height,$.depth);for(let se=0,Re=ce.length;se<Re;se++)if(X=ce[se],y.format!==Kn)if(le!==null)if(re){if(Ae)if(y.layerUpdates.size>0){let ze=_u(X.width,X.height,y.format,y.type);for(let pe of y.layerUpdates){let at=X.data.subarray(pe*ze/X.data.BYTES_PER_ELEMENT,(pe+1)*ze/X.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,pe,X.width,X.height,1,le,at)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,X.width,X.height,$.depth,le,X.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,se,J,X.width,X.height,$.depth,0,X.data,0,0);else Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else re?Ae&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,se,0,0,0,X.width,X.height,$.depth,le,I,X.data):t.texImage3D(n.TEXTURE_2D_ARRAY,se,J,X.width,X.height,$.depth,0,le,I,X.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{re&&ae&&t.texStorage2D(n.TEXTURE_2D,Ge,J,ce[0].width,ce[0].height);for(let se=0,Re=ce.length;se<Re;se++)X=ce[se],y.format!==Kn?le!==null?re?Ae&&t.compressedTexSubImage2D(n.TEXTURE_2D,se,0,0,X.width,X.height,le,X.data):t.compressedTexImage2D(n.TEXTURE_2D,se,J,X.width,X.height,0,X.data):Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):re?Ae&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,X.width,X.height,le,I,X.data):t.texImage2D(n.TEXTURE_2D,se,J,X.width,X.height,0,le,I,X.data)}else if(y.isDataArrayTexture)if(re){if(ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ge,J,$.width,$.height,$.depth),Ae)if(y.layerUpdates.size>0){let se=_u($.width,$.height,y.format,y.type);for(let Re of y.layerUpdates){let ze=$.data.subarray(Re*se/$.data.BYTES_PER_ELEMENT,(Re+1)*se/$.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Re,$.width,$.height,1,le,I,ze)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,$.width,$.height,$.depth,le,I,$.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,J,$.width,$.height,$.depth,0,le,I,$.data);else if(y.isData3DTexture)re?(ae&&t.texStorage3D(n.TEXTURE_3D,Ge,J,$.width,$.height,$.depth),Ae&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,$.width,$.height,$.depth,le,I,$.data)):t.texImage3D(n.TEXTURE_3D,0,J,$.width,$.height,$.depth,0,le,I,$.data);else if(y.isFramebufferTexture){if(ae)if(re)t.texStorage2D(n.TEXTURE_2D,Ge,J,$.width,$.height);else{let se=$.width,Re=$.height;for(let ze=0;ze<Ge;ze++)t.texImage2D(n.TEXTURE_2D,ze,J,se,Re,0,le,I,null),se>>=1,Re>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let se=n.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),$.parentNode!==se){se.appendChild($),f.add(y),se.onpaint=Re=>{let ze=Re.changedElements;for(let pe of f)ze.includes(pe.image)&&(pe.needsUpdate=!0)},se.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,$);else{let ze=n.RGBA,pe=n.RGBA,at=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ze,pe,at,$)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(ce.length>0){if(re&&ae){let se=Ue(ce[0]);t.texStorage2D(n.TEXTURE_2D,Ge,J,se.width,se.height)}for(let se=0,Re=ce.length;se<Re;se++)X=ce[se],re?Ae&&t.texSubImage2D(n.TEXTURE_2D,se,0,0,le,I,X):t.texImage2D(n.TEXTURE_2D,se,J,le,I,X);y.generateMipmaps=!1}else if(re){if(ae){let se=Ue($);t.texStorage2D(n.TEXTURE_2D,Ge,J,se.width,se.height)}Ae&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,le,I,$)}else t.texImage2D(n.TEXTURE_2D,0,J,le,I,$);E(y)&&y.mipmapsAutoUpdate===!0&&M(ne),ue.__version=oe.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function xn(T,y,k){if(y.image.length!==6)return;let ne=ut(T,y),Q=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,T.__webglTexture,n.TEXTURE0+k);let oe=i.get(Q);if(Q.version!==oe.__version||ne===!0){t.activeTexture(n.TEXTURE0+k);let ue=Ke.getPrimaries(Ke.workingColorSpace),Z=y.colorSpace===Ei?null:Ke.getPrimaries(y.colorSpace),$=y.colorSpace===Ei||ue===Z?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,$);let le=y.isCompressedTexture||y.image[0].isCompressedTexture,I=y.image[0]&&y.image[0].isDataTexture,J=[];for(let pe=0;pe<6;pe++)!le&&!I?J[pe]=S(y.image[pe],!0,s.maxCubemapSize):J[pe]=I?y.image[pe].image:y.image[pe],J[pe]=Ie(y,J[pe]);let X=J[0],ce=r.convert(y.format,y.colorSpace),re=r.convert(y.type),ae=R(y.internalFormat,ce,re,y.normalized,y.colorSpace),Ae=y.isVideoTexture!==!0,Ge=oe.__version===void 0||ne===!0,se=Q.dataReady,Re=w(y,X);ot(n.TEXTURE_CUBE_MAP,y);let ze;if(y.isDepthTexture){if(ae=v(y.format===Ti,y.type),Ge)if(Ae)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,ae,X.width,X.height);else for(let pe=0;pe<6;pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,X.width,X.height,0,ce,re,null)}else if(le){Ae&&Ge&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Re,ae,X.width,X.height);for(let pe=0;pe<6;pe++){ze=J[pe].mipmaps;for(let at=0;at<ze.length;at++){let $t=ze[at];y.format!==Kn?ce!==null?Ae?se&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at,0,0,$t.width,$t.height,ce,$t.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at,ae,$t.width,$t.height,0,$t.data):Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at,0,0,$t.width,$t.height,ce,re,$t.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at,ae,$t.width,$t.height,0,ce,re,$t.data)}}}else{if(ze=y.mipmaps,Ae&&Ge){ze.length>0&&Re++;let pe=Ue(J[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Re,ae,pe.width,pe.height)}for(let pe=0;pe<6;pe++)if(I){Ae?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,J[pe].width,J[pe].height,ce,re,J[pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,J[pe].width,J[pe].height,0,ce,re,J[pe].data);for(let at=0;at<ze.length;at++){let Ci=ze[at].image[pe].image;Ae?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at+1,0,0,Ci.width,Ci.height,ce,re,Ci.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at+1,ae,Ci.width,Ci.height,0,ce,re,Ci.data)}}else{Ae?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,ce,re,J[pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,ae,ce,re,J[pe]);for(let at=0;at<ze.length;at++){let $t=ze[at];Ae?se&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at+1,0,0,ce,re,$t.image[pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pe,at+1,ae,ce,re,$t.image[pe])}}}E(y)&&y.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),oe.__version=Q.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function St(T,y,k,ne,Q,oe){let ue=r.convert(k.format,k.colorSpace),Z=r.convert(k.type),$=R(k.internalFormat,ue,Z,k.normalized,k.colorSpace),le=i.get(y),I=i.get(k);if(I.__renderTarget=y,!le.__hasExternalTextures){let J=Math.max(1,y.width>>oe),X=Math.max(1,y.height>>oe);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,oe,$,J,X,y.depth,0,ue,Z,null):t.texImage2D(Q,oe,$,J,X,0,ue,Z,null)}t.bindFramebuffer(n.FRAMEBUFFER,T),fe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,Q,I.__webglTexture,0,yt(y)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ne,Q,I.__webglTexture,oe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ni(T,y,k){if(n.bindRenderbuffer(n.RENDERBUFFER,T),y.depthBuffer){let ne=y.depthTexture,Q=ne&&ne.isDepthTexture?ne.type:null,oe=v(y.stencilBuffer,Q),ue=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;fe(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,yt(y),oe,y.width,y.height):k?n.renderbufferStorageMultisample(n.RENDERBUFFER,yt(y),oe,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,oe,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ue,n.RENDERBUFFER,T)}else{let ne=y.textures;for(let Q=0;Q<ne.length;Q++){let oe=ne[Q],ue=r.convert(oe.format,oe.colorSpace),Z=r.convert(oe.type),$=R(oe.internalFormat,ue,Z,oe.normalized,oe.colorSpace);fe(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,yt(y),$,y.width,y.height):k?n.renderbufferStorageMultisample(n.RENDERBUFFER,yt(y),$,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,$,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Zt(T,y,k){let ne=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,T),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=i.get(y.depthTexture);Q.__renderTarget=y;let oe=ne?y.depthTexture.image[0]:y.depthTexture.image;(!Q.__webglTexture||oe.width!==y.width||oe.height!==y.height)&&(oe.width=y.width,oe.height=y.height,y.depthTexture.needsUpdate=!0),ne?_e(y.depthTexture,0):ge(y.depthTexture,0);let ue=Q.__webglTexture,Z=yt(y),$=ne?n.TEXTURE_CUBE_MAP_POSITIVE_X+k:n.TEXTURE_2D,le=y.depthTexture.format===Ti?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===vi)fe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,$,ue,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,le,$,ue,0);else if(y.depthTexture.format===Ti)fe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,$,ue,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,le,$,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Nn(T){let y=i.get(T),k=T.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==T.depthTexture){let ne=T.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),ne){let Q=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,ne.removeEventListener("dispose",Q)};ne.addEventListener("dispose",Q),y.__depthDisposeCallback=Q}y.__boundDepthTexture=ne}if(T.depthTexture&&!y.__autoAllocateDepthBuffer)if(k)for(let ne=0;ne<6;ne++)Zt(y.__webglFramebuffer[ne],T,ne);else T.texture.mipmaps.length>0?Zt(y.__webglFramebuffer[0],T,0):Zt(y.__webglFramebuffer,T,0);else if(k){y.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[ne]),y.__webglDepthbuffer[ne]===void 0)y.__webglDepthbuffer[ne]=n.createRenderbuffer(),ni(y.__webglDepthbuffer[ne],T,!1);else{let Q=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=y.__webglDepthbuffer[ne];n.bindRenderbuffer(n.RENDERBUFFER,oe),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,oe)}}else if(T.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),ni(y.__webglDepthbuffer,T,!1);else{let Q=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,oe),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,oe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Un(T,y,k){let ne=i.get(T);y!==void 0&&St(ne.__webglFramebuffer,T,T.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),k!==void 0&&Nn(T)}function On(T){let y=T.texture,k=i.get(T),ne=i.get(y);T.addEventListener("dispose",G),B(T);let Q=T.textures,oe=T.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=n.createTexture()),ne.__version=y.version,o.memory.textures++),oe){k.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(y.mipmaps.length>0){k.__webglFramebuffer[Z]=[];for(let $=0;$<y.mipmaps.length;$++)k.__webglFramebuffer[Z][$]=n.createFramebuffer()}else k.__webglFramebuffer[Z]=n.createFramebuffer()}else{if(y.mipmaps.length>0){k.__webglFramebuffer=[];for(let Z=0;Z<y.mipmaps.length;Z++)k.__webglFramebuffer[Z]=n.createFramebuffer()}else k.__webglFramebuffer=n.createFramebuffer();if(ue)for(let Z=0,$=Q.length;Z<$;Z++){let le=i.get(Q[Z]);le.__webglTexture===void 0&&(le.__webglTexture=n.createTexture(),o.memory.textures++)}if(T.samples>0&&fe(T)===!1){k.__webglMultisampledFramebuffer=n.createFramebuffer(),k.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let $=Q[Z];k.__webglColorRenderbuffer[Z]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,k.__webglColorRenderbuffer[Z]);let le=r.convert($.format,$.colorSpace),I=r.convert($.type),J=R($.internalFormat,le,I,$.normalized,$.colorSpace,T.isXRRenderTarget===!0),X=yt(T);n.renderbufferStorageMultisample(n.RENDERBUFFER,X,J,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Z,n.RENDERBUFFER,k.__webglColorRenderbuffer[Z])}n.bindRenderbuffer(n.RENDERBUFFER,null),T.depthBuffer&&(k.__webglDepthRenderbuffer=n.createRenderbuffer(),ni(k.__webglDepthRenderbuffer,T,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(oe){t.bindTexture(n.TEXTURE_CUBE_MAP,ne.__webglTexture),ot(n.TEXTURE_CUBE_MAP,y);for(let Z=0;Z<6;Z++)if(y.mipmaps.length>0)for(let $=0;$<y.mipmaps.length;$++)St(k.__webglFramebuffer[Z][$],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,$);else St(k.__webglFramebuffer[Z],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);E(y)?M(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Z=0,$=Q.length;Z<$;Z++){let le=Q[Z],I=i.get(le),J=n.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(J=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,I.__webglTexture),ot(J,le),St(k.__webglFramebuffer,T,le,n.COLOR_ATTACHMENT0+Z,J,0),E(le)&&M(J)}t.unbindTexture()}else{let Z=n.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(Z=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Z,ne.__webglTexture),ot(Z,y),y.mipmaps.length>0)for(let $=0;$<y.mipmaps.length;$++)St(k.__webglFramebuffer[$],T,y,n.COLOR_ATTACHMENT0,Z,$);else St(k.__webglFramebuffer,T,y,n.COLOR_ATTACHMENT0,Z,0);E(y)?M(Z):y.mipmaps.length>0&&n.texParameteri(Z,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}T.depthBuffer&&Nn(T)}function U(T){let y=T.textures;for(let k=0,ne=y.length;k<ne;k++){let Q=y[k];if(E(Q)&&Q.mipmapsAutoUpdate===!0){let oe=C(T),ue=i.get(Q).__webglTexture;t.bindTexture(oe,ue),M(oe),t.unbindTexture()}}}let Fn=[];function vt(T){if(T.samples>0){if(fe(T)===!1){let y=T.textures,k=T.width,ne=T.height,Q=n.COLOR_BUFFER_BIT,oe=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=i.get(T),Z=y.length>1;if(Z)for(let le=0;le<y.length;le++)t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let le=0;le<y.length;le++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),Z){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let I=i.get(y[le]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,I,0)}n.blitFramebuffer(0,0,k,ne,0,0,k,ne,Q,n.NEAREST),c===!0&&(Fn.length=0,Fn.push(n.COLOR_ATTACHMENT0+le),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&Fn.push(oe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Fn))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Z)for(let le=0;le<y.length;le++){t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let I=i.get(y[le]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,I,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&c){let y=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function yt(T){return Math.min(s.maxSamples,T.samples)}function fe(T){let y=i.get(T);return T.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Bt(T){let y=o.render.frame;h.get(T)!==y&&(h.set(T,y),T.update())}function Ie(T,y){let k=T.colorSpace,ne=T.format,Q=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||k!==Zr&&k!==Ei&&(Ke.getTransfer(k)===rt?(ne!==Kn||Q!==Mn)&&Ce("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):De("WebGLTextures: Unsupported texture color space:",k)),y}function Ue(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(l.width=T.naturalWidth||T.width,l.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(l.width=T.displayWidth,l.height=T.displayHeight):(l.width=T.width,l.height=T.height),l}this.allocateTextureUnit=Fe,this.resetTextureUnits=ee,this.getTextureUnits=te,this.setTextureUnits=Te,this.setTexture2D=ge,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=_e,this.rebindTextures=Un,this.setupRenderTarget=On,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=vt,this.setupDepthRenderbuffer=Nn,this.setupFrameBufferTexture=St,this.useMultisampledRTT=fe,this.dispose=Y}function Qb(n,e){function t(i,s=Ei){let r,o=Ke.getTransfer(s);if(i===Mn)return n.UNSIGNED_BYTE;if(i===bl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Sl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===tu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===nu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Qh)return n.BYTE;if(i===eu)return n.SHORT;if(i===pr)return n.UNSIGNED_SHORT;if(i===xl)return n.INT;if(i===jn)return n.UNSIGNED_INT;if(i===Hn)return n.FLOAT;if(i===Jn)return n.HALF_FLOAT;if(i===iu)return n.ALPHA;if(i===su)return n.RGB;if(i===Kn)return n.RGBA;if(i===vi)return n.DEPTH_COMPONENT;if(i===Ti)return n.DEPTH_STENCIL;if(i===Ml)return n.RED;if(i===wl)return n.RED_INTEGER;if(i===Ki)return n.RG;if(i===Tl)return n.RG_INTEGER;if(i===El)return n.RGBA_INTEGER;if(i===Mo||i===wo||i===To||i===Eo)if(o===rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Mo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===wo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===To)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Eo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Mo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===wo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===To)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Eo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Al||i===Rl||i===Cl||i===Pl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Al)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Rl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Cl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Pl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Il||i===Ll||i===Dl||i===Nl||i===Ul||i===Ao||i===Ol)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Il||i===Ll)return o===rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Dl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Nl)return r.COMPRESSED_R11_EAC;if(i===Ul)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ao)return r.COMPRESSED_RG11_EAC;if(i===Ol)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Fl||i===Bl||i===kl||i===zl||i===Gl||i===Vl||i===Hl||i===Wl||i===Xl||i===ql||i===Yl||i===Zl||i===$l||i===jl)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Fl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Bl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===kl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===zl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Gl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Vl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Hl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Wl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Xl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ql)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Yl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Zl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===$l)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===jl)return o===rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Jl||i===Kl||i===Ql)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Jl)return o===rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ql)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ec||i===tc||i===Ro||i===nc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===ec)return r.COMPRESSED_RED_RGTC1_EXT;if(i===tc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ro)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===nc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ws?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var eS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Eu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ao(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Gn({vertexShader:eS,fragmentShader:tS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new mt(new ys(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Au=class extends $n{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,f=null,d=null,u=null,_=null,b=typeof XRWebGLBinding<"u",m=new Eu,g={},S=t.getContextAttributes(),E=null,M=null,C=[],R=[],v=new ye,w=null,B=null,N=new hn;N.viewport=new bt;let O=new hn;O.viewport=new bt;let G=[N,O],W=new ml,D=null,Y=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let ge=C[j];return ge===void 0&&(ge=new ar,C[j]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(j){let ge=C[j];return ge===void 0&&(ge=new ar,C[j]=ge),ge.getGripSpace()},this.getHand=function(j){let ge=C[j];return ge===void 0&&(ge=new ar,C[j]=ge),ge.getHandSpace()};function K(j){let ge=R.indexOf(j.inputSource);if(ge===-1)return;let be=C[ge];be!==void 0&&(be.update(j.inputSource,j.frame,l||o),be.dispatchEvent({type:j.type,data:j.inputSource}))}function H(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ie);for(let j=0;j<C.length;j++){let ge=R[j];ge!==null&&(R[j]=null,C[j].disconnect(ge))}D=null,Y=null,m.reset();for(let j in g)delete g[j];if(e.setRenderTarget(E),u=null,d=null,f=null,s=null,M=null,Fe.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),B!==null){let j=B.camera;j.fov=B.fov,j.zoom=B.zoom,j.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&Ce("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&Ce("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(j){l=j},this.getBaseLayer=function(){return d!==null?d:u},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ie),S.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,_e=null;S.depth&&(_e=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=S.stencil?Ti:vi,Pe=S.stencil?ws:jn);let ke={colorFormat:t.RGBA8,depthFormat:_e,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(ke),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new In(d.textureWidth,d.textureHeight,{format:Kn,type:Mn,depthTexture:new Mi(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};u=new XRWebGLLayer(s,t,be),s.updateRenderState({baseLayer:u}),e.setPixelRatio(1),e.setSize(u.framebufferWidth,u.framebufferHeight,!1),M=new In(u.framebufferWidth,u.framebufferHeight,{format:Kn,type:Mn,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),Fe.setContext(s),Fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ie(j){for(let ge=0;ge<j.removed.length;ge++){let be=j.removed[ge],Pe=R.indexOf(be);Pe>=0&&(R[Pe]=null,C[Pe].disconnect(be))}for(let ge=0;ge<j.added.length;ge++){let be=j.added[ge],Pe=R.indexOf(be);if(Pe===-1){for(let ke=0;ke<C.length;ke++)if(ke>=R.length){R.push(be),Pe=ke;break}else if(R[ke]===null){R[ke]=be,Pe=ke;break}if(Pe===-1)break}let _e=C[Pe];_e&&_e.connect(be)}}function q(j,ge){ge===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(ge.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let ge=j.near,be=j.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(be=m.depthFar)),W.near=O.near=N.near=ge,W.far=O.far=N.far=be,(D!==W.near||Y!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),D=W.near,Y=W.far),W.layers.mask=j.layers.mask|6,N.layers.mask=W.layers.mask&-5,O.layers.mask=W.layers.mask&-3;let Pe=j.parent,_e=W.cameras;q(W,Pe);for(let ke=0;ke<_e.length;ke++)q(_e[ke],Pe);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&j.isPerspectiveCamera&&(B={camera:j,fov:j.fov,zoom:j.zoom}),ee(j,W,Pe)};function ee(j,ge,be){be===null?j.matrix.copy(ge.matrixWorld):(j.matrix.copy(be.matrixWorld),j.matrix.invert(),j.matrix.multiply(ge.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(ge.projectionMatrix),j.projectionMatrixInverse.copy(ge.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=sr*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&u===null))return c},this.setFoveation=function(j){c=j,d!==null&&(d.fixedFoveation=j),u!==null&&u.fixedFoveation!==void 0&&(u.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(j){return g[j]};let te=null;function Te(j,ge){if(h=ge.getViewerPose(l||o),_=ge,h!==null){let be=h.views;u!==null&&(e.setRenderTargetFramebuffer(M,u.framebuffer),e.setRenderTarget(M));let Pe=!1;be.length!==W.cameras.length&&(W.cameras.length=0,Pe=!0);for(let Le=0;Le<be.length;Le++){let ot=be[Le],ut=null;if(u!==null)ut=u.getViewport(ot);else{let tn=f.getViewSubImage(d,ot);ut=tn.viewport,Le===0&&(e.setRenderTargetTextures(M,tn.colorTexture,tn.depthStencilTexture),e.setRenderTarget(M))}let $e=G[Le];$e===void 0&&($e=new hn,$e.layers.enable(Le),$e.viewport=new bt,G[Le]=$e),$e.matrix.fromArray(ot.transform.matrix),$e.matrix.decompose($e.position,$e.quaternion,$e.scale),$e.projectionMatrix.fromArray(ot.projectionMatrix),$e.projectionMatrixInverse.copy($e.projectionMatrix).invert(),$e.viewport.set(ut.x,ut.y,ut.width,ut.height),Le===0&&(W.matrix.copy($e.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pe===!0&&W.cameras.push($e)}let _e=s.enabledFeatures;if(_e&&_e.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=i.getBinding();let Le=f.getDepthInformation(be[0]);Le&&Le.isValid&&Le.texture&&m.init(Le,s.renderState)}if(_e&&_e.includes("camera-access")&&b){e.state.unbindTexture(),f=i.getBinding();for(let Le=0;Le<be.length;Le++){let ot=be[Le].camera;if(ot){let ut=g[ot];ut||(ut=new ao,g[ot]=ut);let $e=f.getCameraImage(ot);ut.sourceTexture=$e}}}}for(let be=0;be<C.length;be++){let Pe=R[be],_e=C[be];Pe!==null&&_e!==void 0&&_e.update(Pe,ge,l||o)}te&&te(j,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),_=null}let Fe=new im;Fe.setAnimationLoop(Te),this.setAnimationLoop=function(j){te=j},this.dispose=function(){}}},nS=new qe,fm=new Ne;fm.set(-1,0,0,0,1,0,0,0,1);function iS(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,pu(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,S,E,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),f(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&u(m,g,M)):g.isMeshMatcapMaterial?(r(m,g),_(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),b(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,S,E):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===vn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===vn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let S=e.get(g),E=S.envMap,M=S.envMapRotation;E&&(m.envMap.value=E,m.envMapRotation.value.setFromMatrix4(nS.makeRotationFromEuler(M)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(fm),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,S,E){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*S,m.scale.value=E*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function f(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function u(m,g,S){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===vn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=S.texture,m.transmissionSamplerSize.value.set(S.width,S.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let S=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(S.matrixWorld),m.nearDistance.value=S.shadow.camera.near,m.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function sS(n,e,t,i){let s={},r={};function o(S,E){let M=E.program;i.uniformBlockBinding(S,M,s[S.id])}function a(S,E){let M=s[S.id];M===void 0&&(_(S),M=c(S),s[S.id]=M,S.addEventListener("dispose",m));let C=E.program;i.updateUBOMapping(S,C);let R=e.render.frame;r[S.id]!==R&&(l(S),r[S.id]=R)}function c(S){let E=n.createBuffer(),M=S.__size,C=S.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,M,C),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function l(S){let E=s[S.id],M=S.uniforms,C=S.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let R=0,v=M.length;R<v;R++){let w=M[R];if(Array.isArray(w))for(let B=0,N=w.length;B<N;B++)h(w[B],R,B,C);else h(w,R,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(S,E,M,C){if(d(S,E,M,C)===!0){let R=S.__offset,v=S.value;if(Array.isArray(v)){let w=0;for(let B=0;B<v.length;B++){let N=v[B],O=b(N,!0);f(N,S.__data,w),w+=O.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,S.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,R,S.__data)}}function f(S,E,M){typeof S=="number"||typeof S=="boolean"?E[M]=S:S.isMatrix3?(E[M]=S.elements[0],E[M+1]=S.elements[1],E[M+2]=S.elements[2],E[M+3]=0,E[M+4]=S.elements[3],E[M+5]=S.elements[4],E[M+6]=S.elements[5],E[M+7]=0,E[M+8]=S.elements[6],E[M+9]=S.elements[7],E[M+10]=S.elements[8],E[M+11]=0):ArrayBuffer.isView(S)?E.set(S.subarray(0,E.length-M),M):S.toArray(E,M)}function d(S,E,M,C){let R=S.value,v=E+"_"+M;if(Array.isArray(R)){C[v]===void 0&&(C[v]=[]);let w=C[v],B=!1;for(let N=0;N<R.length;N++)u(R[N],w,N)===!0&&(B=!0);return B}return u(R,C,v)}function u(S,E,M){if(E[M]===void 0)return typeof S=="number"||typeof S=="boolean"?E[M]=S:ArrayBuffer.isView(S)?E[M]=S.slice():E[M]=S.clone(),!0;{let C=E[M];if(typeof S=="number"||typeof S=="boolean"){if(C!==S)return E[M]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(C.equals(S)===!1)return C.copy(S),!0}}return!1}function _(S){let E=S.uniforms,M=0,C=16;for(let v=0,w=E.length;v<w;v++){let B=Array.isArray(E[v])?E[v]:[E[v]];for(let N=0,O=B.length;N<O;N++){let G=B[N],W=Array.isArray(G.value)?G.value:[G.value],D=Array.isArray(E[v])||Array.isArray(G.value),Y=M;for(let H=0,ie=W.length;H<ie;H++){let q=W[H],ee=b(q,D),te=M%C,Te=te%ee.boundary,Fe=te+Te;M+=Te,Fe!==0&&C-Fe<ee.storage&&(M+=C-Fe),H===0&&(Y=M),M+=ee.storage}let K=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new K((M-Y)/Float32Array.BYTES_PER_ELEMENT),G.__offset=Y}}let R=M%C;return R>0&&(M+=C-R),S.__size=M,S.__cache={},this}function b(S,E){let M={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(M.boundary=4,M.storage=4):S.isVector2?(M.boundary=8,M.storage=8):S.isVector3||S.isColor?(M.boundary=16,M.storage=12):S.isVector4?(M.boundary=16,M.storage=16):S.isMatrix3?(M.boundary=16,M.storage=48):S.isMatrix4?(M.boundary=16,M.storage=64):S.isTexture?Ce("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(M.boundary=16,M.storage=S.byteLength):Ce("WebGLRenderer: Unsupported uniform value type.",S),E===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(S){let E=S.target;E.removeEventListener("dispose",m),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function g(){for(let S in s)n.deleteBuffer(s[S]);s={},r={}}return{bind:o,update:a,dispose:g}}var rS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ri=null;function oS(){return ri===null&&(ri=new to(rS,16,16,Ki,Jn),ri.name="DFG_LUT",ri.minFilter=gn,ri.magFilter=gn,ri.wrapS=si,ri.wrapT=si,ri.generateMipmaps=!1,ri.needsUpdate=!0),ri}var ac=class{constructor(e={}){let{canvas:t=Ep(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:u=Mn}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let b=u,m=new Set([El,Tl,wl]),g=new Set([Mn,jn,pr,ws,bl,Sl]),S=new Uint32Array(4),E=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},C=null,R=null,v=[],w=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,O=!1,G=null,W=null,D=null,Y=null;this._outputColorSpace=Rn;let K=0,H=0,ie=null,q=-1,ee=null,te=new bt,Te=new bt,Fe=null,j=new Oe(0),ge=0,be=t.width,Pe=t.height,_e=1,ke=null,Pt=null,Le=new bt(0,0,be,Pe),ot=new bt(0,0,be,Pe),ut=!1,$e=new Vi,tn=new Wa,Ft=!1,xn=!1,St=new qe,ni=new P,Zt=new bt,Nn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Un=!1;function On(){return ie===null?_e:1}let U=i;function Fn(x,L){return t.getContext(x,L)}let vt,yt,fe,Bt,Ie,Ue,T,y,k,ne,Q,oe,ue,Z,$,le,I,J,X,ce,re,ae,Ae;try{let x={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Re,!1),t.addEventListener("webglcontextrestored",ze,!1),t.addEventListener("webglcontextcreationerror",pe,!1),U===null){let L="webgl2";if(U=Fn(L,x),U===null)throw Fn(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ge()}catch(x){throw t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",ze,!1),t.removeEventListener("webglcontextcreationerror",pe,!1),De("WebGLRenderer: "+x.message),x}function Ge(){vt=new _x(U),vt.init(),re=new Qb(U,vt),yt=new ox(U,vt,e,re),fe=new Jb(U,vt),yt.reversedDepthBuffer&&d&&fe.buffers.depth.setReversed(!0),W=U.createFramebuffer(),D=U.createFramebuffer(),Y=U.createFramebuffer(),Bt=new xx(U),Ie=new Fb,Ue=new Kb(U,vt,fe,Ie,yt,re,Bt),T=new gx(N),y=new Sv(U),ae=new sx(U,y),k=new vx(U,y,Bt,ae),ne=new Sx(U,k,y,ae,Bt),J=new bx(U,yt,Ue),$=new ax(Ie),Q=new Ob(N,T,vt,yt,ae,$),oe=new iS(N,Ie),ue=new kb,Z=new Xb(vt),I=new ix(N,T,fe,ne,_,c),le=new jb(N,ne,yt),Ae=new sS(U,Bt,yt,fe),X=new rx(U,vt,Bt),ce=new yx(U,vt,Bt),Bt.programs=Q.programs,N.capabilities=yt,N.extensions=vt,N.properties=Ie,N.renderLists=ue,N.shadowMap=le,N.state=fe,N.info=Bt}b!==Mn&&(B=new wx(b,t.width,t.height,a,s,r));let se=new Au(N,U);this.xr=se,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let x=vt.get("WEBGL_lose_context");x&&x.loseContext()},this.forceContextRestore=function(){let x=vt.get("WEBGL_lose_context");x&&x.restoreContext()},this.getPixelRatio=function(){return _e},this.setPixelRatio=function(x){x!==void 0&&(_e=x,this.setSize(be,Pe,!1))},this.getSize=function(x){return x.set(be,Pe)},this.setSize=function(x,L,V=!0){if(se.isPresenting){Ce("WebGLRenderer: Can't change size while VR device is presenting.");return}be=x,Pe=L,t.width=Math.floor(x*_e),t.height=Math.floor(L*_e),V===!0&&(t.style.width=x+"px",t.style.height=L+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,x,L)},this.getDrawingBufferSize=function(x){return x.set(be*_e,Pe*_e).floor()},this.setDrawingBufferSize=function(x,L,V){be=x,Pe=L,_e=V,t.width=Math.floor(x*V),t.height=Math.floor(L*V),this.setViewport(0,0,x,L)},this.setEffects=function(x){if(b===Mn){De("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(x){for(let L=0;L<x.length;L++)if(x[L].isOutputPass===!0){Ce("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(x||[])},this.getCurrentViewport=function(x){return x.copy(te)},this.getViewport=function(x){return x.copy(Le)},this.setViewport=function(x,L,V,F){x.isVector4?Le.set(x.x,x.y,x.z,x.w):Le.set(x,L,V,F),fe.viewport(te.copy(Le).multiplyScalar(On()).round())},this.getScissor=function(x){return x.copy(ot)},this.setScissor=function(x,L,V,F){x.isVector4?ot.set(x.x,x.y,x.z,x.w):ot.set(x,L,V,F),fe.scissor(Te.copy(ot).multiplyScalar(On()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(x){fe.setScissorTest(ut=x)},this.setOpaqueSort=function(x){ke=x},this.setTransparentSort=function(x){Pt=x},this.getClearColor=function(x){return x.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(x=!0,L=!0,V=!0){let F=0;if(x){let z=!1;if(ie!==null){let de=ie.texture.format;z=m.has(de)}if(z){let de=ie.texture.type,xe=g.has(de),he=I.getClearColor(),ve=I.getClearAlpha(),Ee=he.r,Be=he.g,je=he.b;xe?(S[0]=Ee,S[1]=Be,S[2]=je,S[3]=ve,U.clearBufferuiv(U.COLOR,0,S)):(E[0]=Ee,E[1]=Be,E[2]=je,E[3]=ve,U.clearBufferiv(U.COLOR,0,E))}else F|=U.COLOR_BUFFER_BIT}L&&(F|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),V&&(F|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&U.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(x){x.setRenderer(this),G=x},this.dispose=function(){t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",ze,!1),t.removeEventListener("webglcontextcreationerror",pe,!1),I.dispose(),ue.dispose(),Z.dispose(),Ue.dispose(),Ie.dispose(),T.dispose(),ne.dispose(),k.dispose(),ae.dispose(),Ae.dispose(),Q.dispose(),se.dispose(),se.removeEventListener("sessionstart",ad),se.removeEventListener("sessionend",ld),is.stop()};function Re(x){x.preventDefault(),cu("WebGLRenderer: Context Lost."),O=!0}function ze(){cu("WebGLRenderer: Context Restored."),O=!1;let x=Bt.autoReset,L=le.enabled,V=le.autoUpdate,F=le.needsUpdate,z=le.type;Ge(),Bt.autoReset=x,le.enabled=L,le.autoUpdate=V,le.needsUpdate=F,le.type=z}function pe(x){De("WebGLRenderer: A WebGL context could not be created. Reason: ",x.statusMessage)}function at(x){let L=x.target;L.removeEventListener("dispose",at),$t(L)}function $t(x){Ci(x),Ie.remove(x)}function Ci(x){let L=Ie.get(x).programs;L!==void 0&&(L.forEach(function(V){Q.releaseProgram(V)}),x.isShaderMaterial&&Q.releaseShaderCache(x))}this.renderBufferDirect=function(x,L,V,F,z,de){L===null&&(L=Nn);let xe=z.isMesh&&z.matrixWorld.determinantAffine()<0,he=Xg(x,L,V,F,z);fe.setMaterial(F,xe);let ve=V.index,Ee=1;if(F.wireframe===!0){if(ve=k.getWireframeAttribute(V),ve===void 0)return;Ee=2}let Be=V.drawRange,je=V.attributes.position,Se=Be.start*Ee,Je=(Be.start+Be.count)*Ee;de!==null&&(Se=Math.max(Se,de.start*Ee),Je=Math.min(Je,(de.start+de.count)*Ee)),ve!==null?(Se=Math.max(Se,0),Je=Math.min(Je,ve.count)):je!=null&&(Se=Math.max(Se,0),Je=Math.min(Je,je.count));let It=Je-Se;if(It<0||It===1/0)return;ae.setup(z,F,he,V,ve);let ft,dt=X;if(ve!==null&&(ft=y.get(ve),dt=ce,dt.setIndex(ft)),z.isMesh)F.wireframe===!0?(fe.setLineWidth(F.wireframeLinewidth*On()),dt.setMode(U.LINES)):dt.setMode(U.TRIANGLES);else if(z.isLine){let on=F.linewidth;on===void 0&&(on=1),fe.setLineWidth(on*On()),z.isLineSegments?dt.setMode(U.LINES):z.isLineLoop?dt.setMode(U.LINE_LOOP):dt.setMode(U.LINE_STRIP)}else z.isPoints?dt.setMode(U.POINTS):z.isSprite&&dt.setMode(U.TRIANGLES);if(z.isBatchedMesh)if(vt.get("WEBGL_multi_draw"))dt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let on=z._multiDrawStarts,Me=z._multiDrawCounts,mn=z._multiDrawCount,it=ve?y.get(ve).bytesPerElement:1,ss=Ie.get(F).currentProgram.getUniforms();for(let an=0;an<mn;an++)ss.setValue(U,"_gl_DrawID",an),dt.render(on[an]/it,Me[an])}else if(z.isInstancedMesh)dt.renderInstances(Se,It,z.count);else if(V.isInstancedBufferGeometry){let on=V._maxInstanceCount!==void 0?V._maxInstanceCount:1/0,Me=Math.min(V.instanceCount,on);dt.renderInstances(Se,It,Me)}else dt.render(Se,It)};function od(x,L,V,F){G!==null&&x.isNodeMaterial&&G.setObject(F,x),Ft===!0&&$.setState(x,V,!1),x.transparent===!0&&x.side===yn&&x.forceSinglePass===!1?(x.side=vn,x.needsUpdate=!0,Ar(x,L,F),x.side=Ji,x.needsUpdate=!0,Ar(x,L,F),x.side=yn):Ar(x,L,F)}this.compile=function(x,L,V=null){V===null&&(V=x),G!==null&&G.renderStart(x,L,V),R=Z.get(V),R.init(L),w.push(R),V.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),x!==V&&x.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),R.setupLights(),G!==null&&G.updateLights(R.state.lightsArray),xn=this.localClippingEnabled,Ft=$.init(this.clippingPlanes,xn),Ft===!0&&$.setGlobalState(this.clippingPlanes,L),G!==null&&le.render(R.state.shadowsArray,V,L);let F=new Set;return x.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let de=z.material;if(de)if(Array.isArray(de))for(let xe=0;xe<de.length;xe++){let he=de[xe];od(he,V,L,z),F.add(he)}else od(de,V,L,z),F.add(de)}),R=w.pop(),G!==null&&G.renderEnd(),F},this.compileAsync=function(x,L,V=null){let F=this.compile(x,L,V);return new Promise(z=>{function de(){if(F.forEach(function(xe){let ve=Ie.get(xe).currentProgram;(ve===void 0||ve.isReady())&&F.delete(xe)}),F.size===0){z(x);return}setTimeout(de,10)}vt.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let zc=null;function Hg(x){zc&&zc(x)}function ad(){is.stop()}function ld(){is.start()}let is=new im;is.setAnimationLoop(Hg),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(x){zc=x,se.setAnimationLoop(x),x===null?is.stop():is.start()},se.addEventListener("sessionstart",ad),se.addEventListener("sessionend",ld),this.render=function(x,L){if(L!==void 0&&L.isCamera!==!0){De("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(O===!0)return;G!==null&&G.renderStart(x,L);let V=se.enabled===!0&&se.isPresenting===!0,F=B!==null&&(ie===null||V)&&B.begin(N,ie);if(x.matrixWorldAutoUpdate===!0&&x.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(se.cameraAutoUpdate===!0&&se.updateCamera(L),L=se.getCamera()),x.isScene===!0&&x.onBeforeRender(N,x,L,ie),R=Z.get(x,w.length),R.init(L),R.state.textureUnits=Ue.getTextureUnits(),w.push(R),St.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?tn.setFromArrayCamera(L):$e.setFromProjectionMatrix(St,kn,L.reversedDepth),xn=this.localClippingEnabled,Ft=$.init(this.clippingPlanes,xn),C=ue.get(x,v.length),C.init(),v.push(C),this.info.render.frame++,se.enabled===!0&&se.isPresenting===!0){let xe=N.xr.getDepthSensingMesh();xe!==null&&Gc(xe,L,-1/0,N.sortObjects)}Gc(x,L,0,N.sortObjects),C.finish(),G!==null&&G.updateLights(R.state.lightsArray),N.sortObjects===!0&&C.sort(ke,Pt),Un=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Un&&I.addToRenderList(C,x),this.info.autoReset===!0&&this.info.reset(),Ft===!0&&$.beginShadows();let z=R.state.shadowsArray;if(le.render(z,x,L),Ft===!0&&$.endShadows(),(F&&B.hasRenderPass())===!1){let xe=C.opaque,he=C.transmissive;if(R.setupLights(),L.isArrayCamera){let ve=L.cameras;if(he.length>0)for(let Ee=0,Be=ve.length;Ee<Be;Ee++){let je=ve[Ee];hd(xe,he,x,je)}Un&&I.render(x);for(let Ee=0,Be=ve.length;Ee<Be;Ee++){let je=ve[Ee];cd(C,x,je,je.viewport)}}else he.length>0&&hd(xe,he,x,L),Un&&I.render(x),cd(C,x,L)}ie!==null&&H===0&&(Ue.updateMultisampleRenderTarget(ie),Ue.updateRenderTargetMipmap(ie)),F&&B.end(N),x.isScene===!0&&x.onAfterRender(N,x,L),ae.resetDefaultState(),q=-1,ee=null,w.pop(),w.length>0?(R=w[w.length-1],Ue.setTextureUnits(R.state.textureUnits),Ft===!0&&$.setGlobalState(N.clippingPlanes,R.state.camera)):R=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,G!==null&&G.renderEnd()};function Gc(x,L,V,F){if(x.visible===!1)return;if(x.layers.test(L.layers)){if(x.isGroup)V=x.renderOrder;else if(x.isLOD)x.autoUpdate===!0&&x.update(L);else if(x.isLight)R.pushLight(x),x.castShadow&&R.pushShadow(x);else if(x.isSprite){let xe=L.isArrayCamera?tn:$e;if(!x.frustumCulled||x.intersectsFrustum(xe)){F&&Zt.setFromMatrixPosition(x.matrixWorld).applyMatrix4(St);let he=ne.update(x),ve=x.material;ve.visible&&C.push(x,he,ve,V,Zt.z,null,L)}}else if(x.isMesh||x.isLine||x.isPoints){let xe=L.isArrayCamera?tn:$e;if(!x.frustumCulled||x.intersectsFrustum(xe)){let he=ne.update(x),ve=x.material;if(F&&(x.boundingSphere!==void 0?(x.boundingSphere===null&&x.computeBoundingSphere(),Zt.copy(x.boundingSphere.center)):(he.boundingSphere===null&&he.computeBoundingSphere(),Zt.copy(he.boundingSphere.center)),Zt.applyMatrix4(x.matrixWorld).applyMatrix4(St)),Array.isArray(ve)){let Ee=he.groups;for(let Be=0,je=Ee.length;Be<je;Be++){let Se=Ee[Be],Je=ve[Se.materialIndex];Je&&Je.visible&&C.push(x,he,Je,V,Zt.z,Se,L)}}else ve.visible&&C.push(x,he,ve,V,Zt.z,null,L)}}}let de=x.children;for(let xe=0,he=de.length;xe<he;xe++)Gc(de[xe],L,V,F)}function cd(x,L,V,F){let{opaque:z,transmissive:de,transparent:xe}=x;R.setupLightsView(V),Ft===!0&&$.setGlobalState(N.clippingPlanes,V),F&&fe.viewport(te.copy(F)),z.length>0&&Go(z,L,V),de.length>0&&Go(de,L,V),xe.length>0&&Go(xe,L,V),fe.buffers.depth.setTest(!0),fe.buffers.depth.setMask(!0),fe.buffers.color.setMask(!0),fe.setPolygonOffset(!1)}function hd(x,L,V,F){if((V.isScene===!0?V.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[F.id]===void 0){let Se=vt.has("EXT_color_buffer_half_float")||vt.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[F.id]=new In(1,1,{generateMipmaps:!0,type:Se?Jn:Mn,minFilter:wi,samples:Math.max(4,yt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ke.workingColorSpace})}let de=R.state.transmissionRenderTarget[F.id],xe=F.viewport||te;de.setSize(xe.z*N.transmissionResolutionScale,xe.w*N.transmissionResolutionScale);let he=N.getRenderTarget(),ve=N.getActiveCubeFace(),Ee=N.getActiveMipmapLevel();N.setRenderTarget(de),N.getClearColor(j),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),Un&&I.render(V);let Be=N.toneMapping;N.toneMapping=Vn;let je=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),R.setupLightsView(F),Ft===!0&&$.setGlobalState(N.clippingPlanes,F),Go(x,V,F),Ue.updateMultisampleRenderTarget(de),Ue.updateRenderTargetMipmap(de),vt.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let Je=0,It=L.length;Je<It;Je++){let ft=L[Je],{object:dt,geometry:on,material:Me,group:mn}=ft;if(Me.side===yn&&dt.layers.test(F.layers)){let it=Me.side;Me.side=vn,Me.needsUpdate=!0,ud(dt,V,F,on,Me,mn),Me.side=it,Me.needsUpdate=!0,Se=!0}}Se===!0&&(Ue.updateMultisampleRenderTarget(de),Ue.updateRenderTargetMipmap(de))}N.setRenderTarget(he,ve,Ee),N.setClearColor(j,ge),je!==void 0&&(F.viewport=je),N.toneMapping=Be}function Go(x,L,V){let F=L.isScene===!0?L.overrideMaterial:null;for(let z=0,de=x.length;z<de;z++){let xe=x[z],{object:he,geometry:ve,group:Ee}=xe,Be=xe.material;Be.allowOverride===!0&&F!==null&&(Be=F),he.layers.test(V.layers)&&ud(he,L,V,ve,Be,Ee)}}function ud(x,L,V,F,z,de){G!==null&&z.isNodeMaterial&&G.setObject(x,z),x.onBeforeRender(N,L,V,F,z,de),x.modelViewMatrix.multiplyMatrices(V.matrixWorldInverse,x.matrixWorld),x.normalMatrix.getNormalMatrix(x.modelViewMatrix),z.onBeforeRender(N,L,V,F,x,de),z.transparent===!0&&z.side===yn&&z.forceSinglePass===!1?(z.side=vn,z.needsUpdate=!0,N.renderBufferDirect(V,L,F,z,x,de),z.side=Ji,z.needsUpdate=!0,N.renderBufferDirect(V,L,F,z,x,de),z.side=yn):N.renderBufferDirect(V,L,F,z,x,de),x.onAfterRender(N,L,V,F,z,de)}function dd(x){let L=0;for(let V of x)V.texture!==null&&L++;return L}function Ar(x,L,V){L.isScene!==!0&&(L=Nn);let F=Ie.get(x),z=R.state.lights,de=R.state.shadowsArray,xe=z.state.version,he=Q.getParameters(x,z.state,de,L,V,R.state.lightProbeGridArray),ve=Q.getProgramCacheKey(he),Ee=F.programs;F.environment=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?L.environment:null,F.fog=L.fog;let Be=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap;F.envMap=T.get(x.envMap||F.environment,Be),F.envMapRotation=F.environment!==null&&x.envMap===null?L.environmentRotation:x.envMapRotation,Ee===void 0&&(x.addEventListener("dispose",at),Ee=new Map,F.programs=Ee,F.programVariants=new Map);let je=Ee.get(ve);if(je!==void 0){if(F.currentProgram===je&&F.lightsStateVersion===xe)return pd(x,he),je}else he.uniforms=Q.getUniforms(x),G!==null&&x.isNodeMaterial&&G.build(x,V,he),x.onBeforeCompile(he,N),je=Q.acquireProgram(he,ve),Ee.set(ve,je),F.uniforms=he.uniforms;let Se=F.uniforms;return(!x.isShaderMaterial&&!x.isRawShaderMaterial||x.clipping===!0)&&(Se.clippingPlanes=$.uniform),pd(x,he),F.needsLights=Yg(x),F.lightsStateVersion=xe,F.needsLights&&(Se.ambientLightColor.value=z.state.ambient,Se.lightProbe.value=z.state.probe,Se.sunLights.value=z.state.sun,Se.sunLightShadows.value=z.state.sunShadow,Se.directionalLights.value=z.state.directional,Se.directionalLightShadows.value=z.state.directionalShadow,Se.spotLights.value=z.state.spot,Se.spotLightShadows.value=z.state.spotShadow,Se.rectAreaLights.value=z.state.rectArea,Se.ltc_1.value=z.state.rectAreaLTC1,Se.ltc_2.value=z.state.rectAreaLTC2,Se.pointLights.value=z.state.point,Se.pointLightShadows.value=z.state.pointShadow,Se.hemisphereLights.value=z.state.hemi,Se.sunShadowMatrix.value=z.state.sunShadowMatrix,Se.sunShadowCascade.value=z.state.sunShadowCascade,Se.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Se.spotLightMatrix.value=z.state.spotLightMatrix,Se.spotLightMap.value=z.state.spotLightMap,Se.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=dd(R.state.lightProbeGridArray),F.currentProgram=je,F.uniformsList=null,je}function Wg(x,L,V,F,z){let de=Ie.get(x),xe=de.currentProgram.id+","+F+","+z,he=de.programVariants.get(xe);return he===void 0?(he=Ar(x,L,V),de.programVariants.set(xe,he)):(de.currentProgram=he,de.uniformsList=null,de.outputColorSpace=F,de.toneMapping=z),he}function fd(x){if(x.uniformsList===null){let L=x.currentProgram.getUniforms();x.uniformsList=_r.seqWithValue(L.seq,x.uniforms)}return x.uniformsList}function pd(x,L){let V=Ie.get(x);V.outputColorSpace=L.outputColorSpace,V.batching=L.batching,V.batchingColor=L.batchingColor,V.instancing=L.instancing,V.instancingColor=L.instancingColor,V.instancingMorph=L.instancingMorph,V.skinning=L.skinning,V.morphTargets=L.morphTargets,V.morphNormals=L.morphNormals,V.morphColors=L.morphColors,V.morphTargetsCount=L.morphTargetsCount,V.numClippingPlanes=L.numClippingPlanes,V.numIntersection=L.numClipIntersection,V.vertexAlphas=L.vertexAlphas,V.vertexTangents=L.vertexTangents,V.toneMapping=L.toneMapping}function Xg(x,L,V,F,z){L.isScene!==!0&&(L=Nn),Ue.resetTextureUnits();let de=L.fog,xe=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?L.environment:null,he=ie===null?N.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:Ke.workingColorSpace,ve=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,Ee=T.get(F.envMap||xe,ve),Be=F.vertexColors===!0&&!!V.attributes.color&&V.attributes.color.itemSize===4,je=!!V.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),Se=!!V.morphAttributes.position,Je=!!V.morphAttributes.normal,It=!!V.morphAttributes.color,ft=Vn;F.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(ft=N.toneMapping);let dt=V.morphAttributes.position||V.morphAttributes.normal||V.morphAttributes.color,on=dt!==void 0?dt.length:0,Me=Ie.get(F),mn=R.state.lights;if(Ft===!0&&(xn===!0||x!==ee)){let Mt=x===ee&&F.id===q;$.setState(F,x,Mt)}let it=!1,ss=!1;F.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==mn.state.version||z.isBatchedMesh&&Me.batching===!1||!z.isBatchedMesh&&Me.batching===!0||z.isBatchedMesh&&Me.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Me.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Me.instancing===!1||!z.isInstancedMesh&&Me.instancing===!0||z.isSkinnedMesh&&Me.skinning===!1||!z.isSkinnedMesh&&Me.skinning===!0||z.isInstancedMesh&&Me.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Me.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Me.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Me.instancingMorph===!1&&z.morphTexture!==null||Me.envMap!==Ee||F.fog===!0&&Me.fog!==de||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==$.numPlanes||Me.numIntersection!==$.numIntersection)||Me.vertexAlphas!==Be||Me.vertexTangents!==je||Me.morphTargets!==Se||Me.morphNormals!==Je||Me.morphColors!==It||Me.morphTargetsCount!==on||Me.numLightProbeGrids!==dd(R.state.lightProbeGridArray)?it=!0:(Me.outputColorSpace!==he||Me.toneMapping!==ft)&&(ss=!0):(it=!0,Me.__version=F.version);let an=Me.currentProgram;(it===!0||ss===!0)&&(an=ss===!0?Wg(F,L,z,he,ft):Ar(F,L,z),G&&F.isNodeMaterial&&G.onUpdateProgram(F,an,Me));let Vo=!1,Pi=!1,rs=!1,tt=an.getUniforms(),nn=Me.uniforms;if(fe.useProgram(an.program)&&(Vo=!0,Pi=!0,rs=!0),F.id!==q&&(q=F.id,Pi=!0),Vo||ee!==x){fe.buffers.depth.getReversed()&&x.reversedDepth!==!0&&(x._reversedDepth=!0,x.updateProjectionMatrix()),tt.setValue(U,"projectionMatrix",x.projectionMatrix),tt.setValue(U,"viewMatrix",x.matrixWorldInverse);let jt=tt.map.cameraPosition;jt!==void 0&&jt.setValue(U,ni.setFromMatrixPosition(x.matrixWorld)),yt.logarithmicDepthBuffer&&tt.setValue(U,"logDepthBufFC",2/(Math.log(x.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&tt.setValue(U,"isOrthographic",x.isOrthographicCamera===!0),ee!==x&&(ee=x,Pi=!0,rs=!0)}if(Me.needsLights&&(mn.state.sunShadowMap.length>0&&tt.setValue(U,"sunShadowMap",mn.state.sunShadowMap,Ue),mn.state.directionalShadowMap.length>0&&tt.setValue(U,"directionalShadowMap",mn.state.directionalShadowMap,Ue),mn.state.spotShadowMap.length>0&&tt.setValue(U,"spotShadowMap",mn.state.spotShadowMap,Ue),mn.state.pointShadowMap.length>0&&tt.setValue(U,"pointShadowMap",mn.state.pointShadowMap,Ue)),z.isSkinnedMesh){tt.setOptional(U,z,"bindMatrix"),tt.setOptional(U,z,"bindMatrixInverse");let Mt=z.skeleton;Mt&&(Mt.boneTexture===null&&Mt.computeBoneTexture(),tt.setValue(U,"boneTexture",Mt.boneTexture,Ue))}z.isBatchedMesh&&(tt.setOptional(U,z,"batchingTexture"),tt.setValue(U,"batchingTexture",z._matricesTexture,Ue),tt.setOptional(U,z,"batchingIdTexture"),tt.setValue(U,"batchingIdTexture",z._indirectTexture,Ue),tt.setOptional(U,z,"batchingColorTexture"),z._colorsTexture!==null&&tt.setValue(U,"batchingColorTexture",z._colorsTexture,Ue));let Xn=V.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&J.update(z,V,an),(Pi||Me.receiveShadow!==z.receiveShadow)&&(Me.receiveShadow=z.receiveShadow,tt.setValue(U,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&L.environment!==null&&(nn.envMapIntensity.value=L.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=oS()),Pi){if(tt.setValue(U,"toneMappingExposure",N.toneMappingExposure),Me.needsLights&&qg(nn,rs),de&&F.fog===!0&&oe.refreshFogUniforms(nn,de),oe.refreshMaterialUniforms(nn,F,_e,Pe,R.state.transmissionRenderTarget[x.id]),Me.needsLights&&Me.numLightProbeGrids>0){let Mt=M,jt=0;for(let ci of R.state.lightProbeGridArray)ci.texture!==null&&(Mt.textures[jt]=ci.texture,Mt.min[jt]=ci.boundingBox.min,Mt.max[jt]=ci.boundingBox.max,Mt.resolution[jt]=ci.resolution,jt++);for(let ci in Mt)Mt[ci].length=jt;nn.probesSH.value=Mt.textures,nn.probesMin.value=Mt.min,nn.probesMax.value=Mt.max,nn.probesResolution.value=Mt.resolution}_r.upload(U,fd(Me),nn,Ue)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(_r.upload(U,fd(Me),nn,Ue),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&tt.setValue(U,"center",z.center),tt.setValue(U,"modelViewMatrix",z.modelViewMatrix),tt.setValue(U,"normalMatrix",z.normalMatrix),tt.setValue(U,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let Mt=F.uniformsGroups;for(let jt=0,ci=Mt.length;jt<ci;jt++){let gd=Mt[jt];Ae.update(gd,an),Ae.bind(gd,an)}}return an}function qg(x,L){x.ambientLightColor.needsUpdate=L,x.lightProbe.needsUpdate=L,x.sunLights.needsUpdate=L,x.sunLightShadows.needsUpdate=L,x.directionalLights.needsUpdate=L,x.directionalLightShadows.needsUpdate=L,x.pointLights.needsUpdate=L,x.pointLightShadows.needsUpdate=L,x.spotLights.needsUpdate=L,x.spotLightShadows.needsUpdate=L,x.rectAreaLights.needsUpdate=L,x.hemisphereLights.needsUpdate=L}function Yg(x){return x.isMeshLambertMaterial||x.isMeshToonMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isShadowMaterial||x.isShaderMaterial&&x.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(x,L,V){let F=Ie.get(x);F.__autoAllocateDepthBuffer=x.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Ie.get(x.texture).__webglTexture=L,Ie.get(x.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:V,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(x,L){let V=Ie.get(x);V.__webglFramebuffer=L,V.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(x,L=0,V=0){ie=x,K=L,H=V;let F=null,z=!1,de=!1;if(x){let he=Ie.get(x);if(he.__useDefaultFramebuffer!==void 0){fe.bindFramebuffer(U.FRAMEBUFFER,he.__webglFramebuffer),te.copy(x.viewport),Te.copy(x.scissor),Fe=x.scissorTest,fe.viewport(te),fe.scissor(Te),fe.setScissorTest(Fe),q=-1;return}else if(he.__webglFramebuffer===void 0)Ue.setupRenderTarget(x);else if(he.__hasExternalTextures)Ue.rebindTextures(x,Ie.get(x.texture).__webglTexture,Ie.get(x.depthTexture).__webglTexture);else if(x.depthBuffer){let Be=x.depthTexture;if(he.__boundDepthTexture!==Be){if(Be!==null&&Ie.has(Be)&&(x.width!==Be.image.width||x.height!==Be.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ue.setupDepthRenderbuffer(x)}}let ve=x.texture;(ve.isData3DTexture||ve.isDataArrayTexture||ve.isCompressedArrayTexture)&&(de=!0);let Ee=Ie.get(x).__webglFramebuffer;x.isWebGLCubeRenderTarget?(Array.isArray(Ee[L])?F=Ee[L][V]:F=Ee[L],z=!0):x.samples>0&&Ue.useMultisampledRTT(x)===!1?F=Ie.get(x).__webglMultisampledFramebuffer:Array.isArray(Ee)?F=Ee[V]:F=Ee,te.copy(x.viewport),Te.copy(x.scissor),Fe=x.scissorTest}else te.copy(Le).multiplyScalar(_e).floor(),Te.copy(ot).multiplyScalar(_e).floor(),Fe=ut;if(V!==0&&(F=W),fe.bindFramebuffer(U.FRAMEBUFFER,F)&&fe.drawBuffers(x,F),fe.viewport(te),fe.scissor(Te),fe.setScissorTest(Fe),z){let he=Ie.get(x.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+L,he.__webglTexture,V)}else if(de){let he=L;for(let ve=0;ve<x.textures.length;ve++){let Ee=Ie.get(x.textures[ve]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+ve,Ee.__webglTexture,V,he)}}else if(x!==null&&V!==0){let he=Ie.get(x.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,he.__webglTexture,V)}q=-1};function md(x){let L=Ie.get(x);return(L.__readFormat!==x.format||L.__readType!==x.type)&&(L.__readFormat=x.format,L.__readType=x.type,L.__formatReadable=yt.textureFormatReadable(x.format),L.__typeReadable=yt.textureTypeReadable(x.type)),L}this.readRenderTargetPixels=function(x,L,V,F,z,de,xe,he=0){if(!(x&&x.isWebGLRenderTarget)){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ve=Ie.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&xe!==void 0&&(ve=ve[xe],Array.isArray(ve)&&(ve=ve[0])),ve){fe.bindFramebuffer(U.FRAMEBUFFER,ve);try{let Ee=x.textures[he],Be=Ee.format,je=Ee.type;x.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+he);let Se=md(Ee);if(Se.__formatReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=x.width-F&&V>=0&&V<=x.height-z&&U.readPixels(L,V,F,z,re.convert(Be),re.convert(je),de)}finally{let Ee=ie!==null?Ie.get(ie).__webglFramebuffer:null;fe.bindFramebuffer(U.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(x,L,V,F,z,de,xe,he=0){if(!(x&&x.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ve=Ie.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&xe!==void 0&&(ve=ve[xe],Array.isArray(ve)&&(ve=ve[0])),ve)if(L>=0&&L<=x.width-F&&V>=0&&V<=x.height-z){fe.bindFramebuffer(U.FRAMEBUFFER,ve);let Ee=x.textures[he],Be=Ee.format,je=Ee.type;x.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+he);let Se=md(Ee);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Je=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,Je),U.bufferData(U.PIXEL_PACK_BUFFER,de.byteLength,U.STREAM_READ),U.readPixels(L,V,F,z,re.convert(Be),re.convert(je),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let It=ie!==null?Ie.get(ie).__webglFramebuffer:null;fe.bindFramebuffer(U.FRAMEBUFFER,It);let ft=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Rp(U,ft,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,Je),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,de),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(Je),U.deleteSync(ft),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(x,L=null,V=0){let F=Math.pow(2,-V),z=Math.floor(x.image.width*F),de=Math.floor(x.image.height*F),xe=L!==null?L.x:0,he=L!==null?L.y:0;Ue.setTexture2D(x,0),U.copyTexSubImage2D(U.TEXTURE_2D,V,0,0,xe,he,z,de),fe.unbindTexture()},this.copyTextureToTexture=function(x,L,V=null,F=null,z=0,de=0){let xe,he,ve,Ee,Be,je,Se,Je,It,ft=x.isCompressedTexture?x.mipmaps[de]:x.image;if(V!==null)xe=V.max.x-V.min.x,he=V.max.y-V.min.y,ve=V.isBox3?V.max.z-V.min.z:1,Ee=V.min.x,Be=V.min.y,je=V.isBox3?V.min.z:0;else{let tt=Math.pow(2,-z);xe=Math.floor(ft.width*tt),he=Math.floor(ft.height*tt),x.isDataArrayTexture?ve=ft.depth:x.isData3DTexture?ve=Math.floor(ft.depth*tt):ve=1,Ee=0,Be=0,je=0}F!==null?(Se=F.x,Je=F.y,It=F.z):(Se=0,Je=0,It=0);let dt=re.convert(L.format),on=re.convert(L.type),Me;L.isData3DTexture?(Ue.setTexture3D(L,0),Me=U.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Ue.setTexture2DArray(L,0),Me=U.TEXTURE_2D_ARRAY):(Ue.setTexture2D(L,0),Me=U.TEXTURE_2D),fe.activeTexture(U.TEXTURE0),fe.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,L.flipY),fe.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),fe.pixelStorei(U.UNPACK_ALIGNMENT,L.unpackAlignment);let mn=fe.getParameter(U.UNPACK_ROW_LENGTH),it=fe.getParameter(U.UNPACK_IMAGE_HEIGHT),ss=fe.getParameter(U.UNPACK_SKIP_PIXELS),an=fe.getParameter(U.UNPACK_SKIP_ROWS),Vo=fe.getParameter(U.UNPACK_SKIP_IMAGES);fe.pixelStorei(U.UNPACK_ROW_LENGTH,ft.width),fe.pixelStorei(U.UNPACK_IMAGE_HEIGHT,ft.height),fe.pixelStorei(U.UNPACK_SKIP_PIXELS,Ee),fe.pixelStorei(U.UNPACK_SKIP_ROWS,Be),fe.pixelStorei(U.UNPACK_SKIP_IMAGES,je);let Pi=x.isDataArrayTexture||x.isData3DTexture,rs=L.isDataArrayTexture||L.isData3DTexture;if(x.isDepthTexture){let tt=Ie.get(x),nn=Ie.get(L),Xn=Ie.get(tt.__renderTarget),Mt=Ie.get(nn.__renderTarget);fe.bindFramebuffer(U.READ_FRAMEBUFFER,Xn.__webglFramebuffer),fe.bindFramebuffer(U.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let jt=0;jt<ve;jt++)Pi&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ie.get(x).__webglTexture,z,je+jt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ie.get(L).__webglTexture,de,It+jt)),U.blitFramebuffer(Ee,Be,Ee+xe,Be+he,Se,Je,Se+xe,Je+he,U.DEPTH_BUFFER_BIT,U.NEAREST);fe.bindFramebuffer(U.READ_FRAMEBUFFER,null),fe.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(z!==0||x.isRenderTargetTexture||Ie.has(x)){let tt=Ie.get(x),nn=Ie.get(L);fe.bindFramebuffer(U.READ_FRAMEBUFFER,D),fe.bindFramebuffer(U.DRAW_FRAMEBUFFER,Y);for(let Xn=0;Xn<ve;Xn++)Pi?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,tt.__webglTexture,z,je+Xn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,tt.__webglTexture,z),rs?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,nn.__webglTexture,de,It+Xn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,nn.__webglTexture,de),z!==0?U.blitFramebuffer(Ee,Be,Ee+xe,Be+he,Se,Je,Se+xe,Je+he,U.COLOR_BUFFER_BIT,U.NEAREST):rs?U.copyTexSubImage3D(Me,de,Se,Je,It+Xn,Ee,Be,xe,he):U.copyTexSubImage2D(Me,de,Se,Je,Ee,Be,xe,he);fe.bindFramebuffer(U.READ_FRAMEBUFFER,null),fe.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else rs?x.isDataTexture||x.isData3DTexture?U.texSubImage3D(Me,de,Se,Je,It,xe,he,ve,dt,on,ft.data):L.isCompressedArrayTexture?U.compressedTexSubImage3D(Me,de,Se,Je,It,xe,he,ve,dt,ft.data):U.texSubImage3D(Me,de,Se,Je,It,xe,he,ve,dt,on,ft):x.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,de,Se,Je,xe,he,dt,on,ft.data):x.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,de,Se,Je,ft.width,ft.height,dt,ft.data):U.texSubImage2D(U.TEXTURE_2D,de,Se,Je,xe,he,dt,on,ft);fe.pixelStorei(U.UNPACK_ROW_LENGTH,mn),fe.pixelStorei(U.UNPACK_IMAGE_HEIGHT,it),fe.pixelStorei(U.UNPACK_SKIP_PIXELS,ss),fe.pixelStorei(U.UNPACK_SKIP_ROWS,an),fe.pixelStorei(U.UNPACK_SKIP_IMAGES,Vo),de===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&U.generateMipmap(Me),fe.unbindTexture()},this.initRenderTarget=function(x){Ie.get(x).__webglFramebuffer===void 0&&Ue.setupRenderTarget(x)},this.initTexture=function(x){x.isCubeTexture?Ue.setTextureCube(x,0):x.isData3DTexture?Ue.setTexture3D(x,0):x.isDataArrayTexture||x.isCompressedArrayTexture?Ue.setTexture2DArray(x,0):Ue.setTexture2D(x,0),fe.unbindTexture()},this.resetState=function(){K=0,H=0,ie=null,fe.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return kn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ke._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ke._getUnpackColorSpace()}};var dn=we(null),hc=we(!1),Qe=we(null),Ye=we(null),Qi=we(null),Ai=we([]),ct=we("connecting"),Es=we(0),Do=we(null),uc=we(null),Xt=we("cell"),Qn=we("plan"),wt=we("now"),Ct=we(null),fn=we(null),es=we(new Set),ts=we(new Set),yr=we(new Set),No=we([]),As=we(null),dc=bn(()=>{let n=Ye.value?.trouble.find(e=>e.target===As.value);return n===void 0?null:{pair:n.pair??n.blockers,posture:n.posture}}),ai=we(null),xr=we(""),qt=we(0),pn=we(!1),Dn=we(null),ns=we(null),ei=we(null),et=bn(()=>Qi.value===null||Qi.value.open===null?null:Qi.value),Ru=bn(()=>et.value?.steps.find(n=>n.number===Ct.value)??null),ht=bn(()=>ct.value==="live"||ct.value==="stale"),aS=new Set(["held","idle","needs-help","broken"]),fc=bn(()=>aS.has(Ye.value?.phase??""));function en(n){return dn.value?.can.includes(n)??!1}function pm(n){return Qe.value?.robots.find(e=>e.id===n)?.number??0}function mm(n){let e=Qe.value,t=n.split("/")[0]??n;return(e===null?[]:[...e.components,...e.robots,...e.end_effectors,...e.fixtures,...e.zones]).find(s=>s.id===t)?.name??t}function br(n){if(Ct.value=n,n===null)return;es.value=new Set([...es.value,n]);let e=et.value?.steps.find(t=>t.number===n);e!==void 0&&(qt.value=e.starts_s)}var lS=500,cS=450,hS=400,uS=400,dS=16,fS=400,pc=class{constructor(e){this.ends=e}ends;socket=null;heard_ms=performance.now();sensed_ms=performance.now();lastSensed=0;last=null;isProbing=!1;start(){this.connect(),Gt.subscribe(()=>this.askAgain()),setInterval(()=>this.watch(),100)}async connect(){try{let{ticket:e}=await lt("/api/ws-ticket",{method:"POST",wait_ms:1e3});this.open(e)}catch{this.lose()}}open(e){let t=location.protocol==="https:"?"wss":"ws",i=new WebSocket(`${t}://${location.host}/ws`);i.binaryType="arraybuffer",i.onopen=()=>i.send(JSON.stringify({ticket:e,after:this.last,lang:Gt.value})),i.onmessage=s=>this.hear(s.data),i.onclose=()=>this.lose(),this.socket=i}askAgain(){if(this.socket?.readyState!==WebSocket.OPEN)return;let e=Ai.value[0];Ai.value=[],this.socket.send(JSON.stringify({lang:Gt.value,after:e===void 0?this.last:{run:e.run,n:e.n-1}}))}lose(){this.socket!==null&&(this.socket.onclose=this.socket.onmessage=null,this.socket.close(),this.socket=null),ct.value="lost",setTimeout(()=>{this.connect()},uS)}hear(e){if(this.heard_ms=performance.now(),typeof e!="string"){this.hearBinary(e);return}let t=JSON.parse(e);t.type==="event"?(this.last={run:t.run,n:t.n},Ai.value=[...Ai.value.slice(-fS),t]):t.type==="state"&&(this.back(),Ye.value=t,this.ends.onState(t),this.ends.onSceneEpoch(t.scene_epoch))}back(){ct.value!=="lost"&&ct.value!=="connecting"||(ct.value="stale",this.ends.onConnected())}hearBinary(e){let t=new DataView(e),i=t.getUint8(0);this.ends.onSceneEpoch(t.getUint16(2,!0));let s=t.getFloat64(8,!0),r=new Float32Array(e.slice(dS));if(i===2){uc.value=r;return}Do.value=r,s>this.lastSensed&&(this.lastSensed=s,this.sensed_ms=performance.now(),ct.value==="stale"&&(ct.value="live"),Es.value=0)}watch(){let e=performance.now(),t=e-this.sensed_ms;t>lS&&(Es.value=Math.floor(t/500)/2,ct.value==="live"&&(ct.value="stale")),e-this.heard_ms>cS&&this.socket?.readyState===WebSocket.OPEN&&!this.isProbing&&this.probe()}async probe(){this.isProbing=!0;try{await lt("/api/state",{wait_ms:hS}),this.heard_ms=performance.now()}catch{this.lose()}finally{this.isProbing=!1}}},Cu=8;function gm(n){let e=new DataView(n.buffer,n.byteOffset,n.byteLength),t=new Map;for(let i=0;i+Cu<=n.length;i+=Cu){let[s,r,o,a,c,l,h]=n.subarray(i+1,i+Cu);t.set(e.getUint16(i*4,!0),pS([s,r,o],[a,c,l,h]))}return t}function pS(n,e){let[t=1,i=0,s=0,r=0]=e;return new qe().set(1-2*(s*s+r*r),2*(i*s-t*r),2*(i*r+t*s),n[0]??0,2*(i*s+t*r),1-2*(i*i+r*r),2*(s*r-t*i),n[1]??0,2*(i*r-t*s),2*(s*r+t*i),1-2*(i*i+s*s),n[2]??0,0,0,0,1)}var mS=new Set(["skill_outcome","skill_intent","run_started"]),gS=250,mc=we(0);function _m(){let n=0,e=()=>{n=0,mc.value=mc.peek()+1};return Ze(()=>{let t=Ai.value.at(-1);t!==void 0&&mS.has(t.kind)&&n===0&&(n=window.setTimeout(e,gS))})}var Iu=-1;async function ym(){dn.value=await _S(),dn.value!==null&&(await Promise.all([Lu(),Rs(),bS()]),Ze(()=>{Gt.value,Rs()}),_m(),!Fs&&new pc({onState:yS,onSceneEpoch:n=>{n!==Iu&&Lu(n)},onConnected:vS}).start())}async function _S(){let n=new URLSearchParams(location.hash.slice(1)).get("token");n!==null&&history.replaceState(null,"",location.pathname+location.search);try{return n!==null&&await lt("/api/session",{method:"POST",body:{token:n}}),await lt("/api/session")}catch(e){if(n!==null&&e instanceof Ui){let t=await lt("/api/session").catch(()=>null);if(t!==null)return t}if(e instanceof fs)throw e;return hc.value=!0,null}}function vS(){Rs(),Lu()}function yS(n){let e=n.open?.fingerprint??null,t=et.value?.fingerprint??null,i=e!==t||et.value?.next_step!==n.open?.next_step||n.phase!==vm;vm=n.phase,i&&Rs()}var vm="",Uo=null,Pu=!1;function Rs(){return Uo!==null?(Pu=!0,Uo):(Uo=xS().finally(()=>{Uo=null,Pu&&(Pu=!1,Rs())}),Uo)}async function xS(){let n=await lt(Jt("/api/proposals/open")).catch(()=>null);if(n===null)return;let e=et.value?.fingerprint;Qi.value=n,n.open!==null&&n.fingerprint!==e&&(Ct.value=null,ei.value?.kind==="recorded"&&(ei.value=null),es.value=new Set)}async function Lu(n){n!==void 0&&(Iu=n);let e=await lt("/api/scene").catch(()=>null);e===null||e.hash===Qe.value?.hash||(Iu=e.epoch,Qe.value=e)}async function bS(){Ye.value=await lt("/api/state").catch(()=>null)}var Oo=we(null),Fo=we(!1);async function Ot(n){if(!ht.value||Fo.value||Oo.value!==null)return!1;let e=dn.value?.asks_pin===!0?await SS():{};return e===null||!ht.value?!1:xm({...n,...e,key:crypto.randomUUID(),lang:Gt.value})}function SS(){return new Promise(n=>{Oo.value={give:e=>{Oo.value=null,n(e)}}})}async function xm(n){Fo.value=!0,ei.value=null;try{let e=await lt("/api/decisions",{method:"POST",body:n});return ei.value={kind:"recorded",words:MS(n.verb,e)},!0}catch(e){return ei.value=wS(e,n),!1}finally{Fo.value=!1,Rs()}}function MS(n,e){if(!e.ok)return A("done.second");let t=e.who??"";return n==="approve"?A("done.approved",{who:t}):n==="reject"?A("done.rejected",{who:t}):A("done.other",{who:t})}function wS(n,e){if(n instanceof Ui){let{refusal:t}=n;return t.error==="stale"?{kind:"stale",refusal:t}:{kind:"refused",words:t.message}}if(n instanceof fs)return{kind:"unknown",again:async()=>{await xm(e)}};throw n}function bm(){let n=et.value;return n===null?[]:[n.title,...n.steps.map(e=>`${e.number}. ${e.robot_name} ${e.words}`)]}var gc=we("");async function _c(){try{let n=await lt("/api/hold",{method:"POST",body:{reason:"",key:crypto.randomUUID()},wait_ms:1500});gc.value=n.told_cell?"sent":"failed"}catch{gc.value="failed"}}var Sm=1e3,Mm=we(0),Du=we(0),wm=we("");function Tm(n){let e="";Ze(()=>{let t=et.value,i=t===null?"":`${t.fingerprint} ${t.next_step}`;i!==e&&(e=i,Mm.value=n()+Sm,Du.value=n(),setTimeout(()=>{Du.value=n()},Sm+10))})}function Em(n){wm.value=n}var Am=bn(()=>{let n=et.value;return ht.value?n===null||Ye.value?.phase!=="waiting"?A("plan.none.other"):en("approve")?Fo.value?A("wait.busy"):Du.value<Mm.value?A("wait.changed"):n.differences.length>0&&wm.value!==n.fingerprint?A("wait.differences"):"":A("role.lacks",{role:dn.value?.role??""}):A("link.lost")});function Rm(n){return(et.value?.steps.filter(i=>i.flags.length>0&&!i.is_done&&i.number<=n)??[]).find(i=>!es.value.has(i.number))?.number??null}var TS=Symbol.for("pv"),ES=0;function p(n,e,t,i,s,r){e||(e={});var o,a,c=e;if("ref"in c&&typeof n!="function")for(a in c={},e)a=="ref"?o=e[a]:c[a]=e[a];var l={type:n,props:c,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:TS,__v:--ES,__i:-1,__u:0};return(s||r)&&(l.__source=s,l.__self=r),nt.vnode&&nt.vnode(l),l}function Wn({title:n,onClose:e,children:t,isBeside:i=!1}){let s=Lt(null),r=zd();return gt(()=>{i?s.current?.show():s.current?.showModal()},[i]),p("dialog",{ref:s,"aria-labelledby":r,class:i?"beside":"",onClose:e,children:[p("header",{children:[p("h2",{id:r,children:n}),p("button",{type:"button",class:"quiet",onClick:()=>s.current?.close(),children:A("act.close")}),!i&&!fc.value&&p("button",{type:"button",class:"hold-here",onClick:()=>{_c()},children:A("act.hold")})]}),t]})}var Ri=we(!1),Cs=we([0,0,1]),Ps=we([.6,.6,1.2]),AS=["zone.x","zone.y","zone.z"],RS=["zone.length","zone.width","zone.height"];function Im(){if(!Ri.value)return null;let n=()=>{Ri.value=!1},e=async t=>{t.preventDefault();let i={center_m:Cs.value,size_m:Ps.value,yaw_rad:0};await Ot({fingerprint:et.value?.fingerprint??"",verb:"zone",zone:i})&&n()};return p(Wn,{title:A("zone.title"),onClose:n,isBeside:!0,children:p("form",{onSubmit:t=>{e(t)},children:[p("p",{children:[A("zone.text")," ",p("span",{class:"soft",children:A("zone.tap")})]}),p("div",{class:"numbers",children:[AS.map((t,i)=>p(Cm,{words:A(t),value:Cs.value[i]??0,onChange:s=>Cs.value=Pm(Cs.value,i,s)},t)),RS.map((t,i)=>p(Cm,{words:A(t),min:.05,value:Ps.value[i]??0,onChange:s=>Ps.value=Pm(Ps.value,i,s)},t))]}),p("footer",{children:[p("button",{type:"button",onClick:n,children:A("act.cancel")}),p("button",{type:"submit",class:"warn",disabled:!ht.value||Qe.value===null,children:A("zone.save")})]})]})})}function Cm({words:n,value:e,onChange:t,min:i}){return p("label",{class:"field",children:[n,p("input",{type:"number",step:"0.05",min:i,value:Math.round(e*1e3)/1e3,onInput:s=>t(s.currentTarget.valueAsNumber||0)})]})}function Pm(n,e,t){return n.map((i,s)=>s===e?t:i)}function Lm({plan:n,onClose:e}){let[t]=Xe(n.fingerprint),[i,s]=Xe(null),[r,o]=Xe("");gt(()=>{lt(Jt(`/api/proposals/${t}/alternatives`),{wait_ms:6e4}).then(s,l=>o(l.message))},[t]);let a=l=>{e(),Ot({fingerprint:t,verb:"instead",call:{skill:l.skill,robot:l.robot,arguments:l.arguments}})},c=Ct.value;return p(Wn,{title:A("other.title"),onClose:e,children:[p("p",{class:"soft",children:A("other.note")}),p("h3",{children:A("other.feasible")}),i===null&&r===""&&p("p",{role:"status",children:A("other.loading")}),r!==""&&p("p",{role:"alert",children:A("failed",{reason:r})}),i?.feasible.length===0&&p("p",{children:A("other.none")}),p("ul",{class:"ways",children:i?.feasible.map(l=>p("li",{children:[p("div",{children:[l.words,p("small",{children:[Ni(l.duration_s),l.price_s!==null&&` · ${CS(l.price_s)}`,l.note!==""&&` · ${l.note}`]})]}),p("button",{type:"button",disabled:!ht.value,onClick:()=>a(l),children:A("act.choose")})]},l.words))}),i!==null&&i.infeasible.length>0&&p("details",{children:[p("summary",{children:A("other.infeasible")}),p("ul",{class:"ways",children:i.infeasible.map(l=>p("li",{children:p("div",{children:[l.words,p("small",{children:l.why_not})]})},l.words))})]}),p("footer",{children:[en("zone")&&p("button",{type:"button",onClick:()=>{e(),Ri.value=!0},children:A("other.zone")}),c!==null&&en("new-motion")&&p("button",{type:"button",onClick:()=>{e(),Ot({fingerprint:t,verb:"new-motion",step:c})},children:A("other.motion",{number:c})})]})]})}function CS(n){let e=n>0?"+":n<0?"−":"±";return A("other.price",{seconds:`${e}${Dt(Math.abs(n))}`})}var PS=["wrong-component","wrong-robot","path-unsafe","site-differs","later","other"];function Dm({plan:n,onClose:e}){let[t]=Xe(n.fingerprint),[i,s]=Xe(""),[r,o]=Xe(0),[a,c]=Xe(""),l=async h=>{h.preventDefault(),e(),await Ot({fingerprint:t,verb:"reject",reason:i,step:r,detail:a})};return p(Wn,{title:A("reject.title"),onClose:e,children:p("form",{onSubmit:h=>{l(h)},children:[p("fieldset",{class:"choices",children:[p("legend",{children:A("reject.why")}),PS.map(h=>p("label",{children:[p("input",{type:"radio",name:"reason",value:h,checked:i===h,onChange:()=>s(h)}),A(`reason.${h}`)]},h))]}),p("label",{class:"field",children:[A("reject.step"),p("select",{value:r,onChange:h=>o(Number(h.currentTarget.value)),children:[p("option",{value:0,children:A("reject.whole")}),Ct.value!==null&&p("option",{value:Ct.value,children:A("reject.one",{number:Ct.value})})]})]}),p("label",{class:"field",children:[A("reject.detail"),p("input",{type:"text",value:a,maxLength:300,onInput:h=>c(h.currentTarget.value)})]}),p("footer",{children:[p("button",{type:"button",onClick:e,children:A("act.cancel")}),p("button",{type:"submit",class:"warn",disabled:i===""||!ht.value,children:A("act.reject")})]})]})})}var Is=we("");function Um(){let n=gc.value,e=fc.value,t=ct.value==="lost";return p("section",{class:"hold-area","aria-label":A("act.hold"),children:[e?p(IS,{}):p("button",{type:"button",class:t?"hold unreachable":"hold",onClick:()=>{_c()},children:[p("b",{children:A("act.hold")}),p("small",{children:A(t?"link.lost":"act.hold.note")})]}),p("p",{class:`note ${n}`,role:"status",children:n==="failed"?A("act.hold.failed"):n==="sent"&&Ye.value?.phase==="holding"?A("act.hold.sent"):""})]})}function IS(){let n=Fm(),e=Ye.value?.phase==="idle";return p("button",{type:"button",class:"hold resume",disabled:!ht.value||!en("resume"),...n(t=>{Ot({fingerprint:t,verb:"resume"})}),children:p("b",{children:A(e?"act.start":"act.resume")})})}function Om(){let n=et.value,e=n!==null&&Ye.value?.phase==="waiting";if(gt(()=>{e||(Is.value="")},[e]),!e)return p("div",{class:"acts"});if(Xt.value!=="cell"||Qn.value!=="plan")return p(LS,{code:n.code});let t=n.steps.filter(s=>!s.is_done),i=Ct.value!==null&&t.some(s=>s.number===Ct.value)?Ct.value:null;return p("section",{class:"acts","aria-label":A("acts.label",{code:n.code}),children:[p("button",{type:"button",disabled:!ht.value||!en("reject"),onClick:()=>Is.value="reject",children:A("act.reject")}),p("button",{type:"button",disabled:!ht.value||!en("instead"),onClick:()=>Is.value="other",children:A("act.other")}),p(Nu,{scope:{kind:"step",step:n.next_step},until:n.next_step,words:A("act.step"),note:A("act.step.note",{number:n.next_step})}),p(Nu,{scope:i===null?null:{kind:"until",step:i},until:i??0,words:i===null?A("act.until.none"):A("act.until",{number:i}),note:i===null?A("wait.until"):us("act.all.note",t.filter(s=>s.number<=i).length)}),p(Nu,{scope:{kind:"plan"},until:1/0,words:A("act.all"),note:us("act.all.note",t.length),isMain:!0}),Is.value==="reject"&&p(Dm,{plan:n,onClose:()=>Is.value=""}),Is.value==="other"&&p(Lm,{plan:n,onClose:()=>Is.value=""})]})}function LS({code:n}){let e=()=>{Xt.value="cell",Qn.value="plan"};return p("section",{class:"acts single","aria-label":A("acts.label",{code:n}),children:p("button",{type:"button",onClick:e,children:[p("b",{children:A("act.show")}),p("small",{children:n})]})})}function Nu({scope:n,until:e,words:t,note:i,isMain:s=!1}){let r=Fm(),o=Am.value,a=o===""&&n!==null?Rm(e):null,c=o||(a===null?i:A("wait.flagged",{number:a})),l=o!==""||n===null,h=et.value?.next_step??0,f=d=>{l||(a!==null?(Xt.value="cell",br(a)):Ot({fingerprint:d,verb:"approve",next_step:h,scope:n,shown:bm()}))};return p("button",{type:"button",class:s?"approve main":"approve","aria-disabled":l,"data-scope":n?.kind??"none",...r(f),children:[p("b",{children:t}),p("small",{children:c})]})}function Fm(){let n=Lt(null),e=et.value?.fingerprint??"";return t=>({"data-fingerprint":e,onPointerDown:i=>n.current=Nm(i),onKeyDown:i=>!i.repeat&&(n.current=Nm(i)),onPointerCancel:()=>n.current=null,onClick:()=>{let i=n.current??e;n.current=null,t(i)}})}var Nm=n=>n.currentTarget.dataset.fingerprint??"";function Bm(){return hc.value?p("div",{class:"banner",role:"alert",children:[p("p",{children:[p("b",{children:A("signed-out.title")})," ",A("signed-out.text")]}),p(DS,{})]}):ct.value==="lost"?p("div",{class:"banner lost",role:"alert",children:[p("p",{children:[p("b",{children:A("lost.title")})," ",A("lost.text")]}),p("label",{children:[A("lost.note"),p("input",{type:"text"})]})]}):Ye.value?.phase==="broken"?p("div",{class:"banner",role:"alert",children:[p("b",{children:A("broken")})," ",Ye.value.words]}):null}function DS(){let[n,e]=Xe(""),[t,i]=Xe(""),[s,r]=Xe("");return p("form",{class:"sign-in",onSubmit:a=>{a.preventDefault(),lt("/api/session",{method:"POST",body:{user:n,token:t}}).then(()=>location.reload(),c=>r(c.message))},children:[p("p",{children:A("sign-in.or")}),p("label",{class:"field",children:[A("sign-in.user"),p("input",{type:"text",name:"user",autocomplete:"username",required:!0,value:n,onInput:a=>e(a.currentTarget.value)})]}),p("label",{class:"field",children:[A("sign-in.token"),p("input",{type:"password",name:"token",autocomplete:"current-password",required:!0,value:t,onInput:a=>i(a.currentTarget.value)})]}),p("button",{type:"submit",children:A("sign-in.go")}),s!==""&&p("p",{role:"alert",children:s})]})}var Bo=class extends Li{state={fault:""};componentDidCatch(e){this.setState({fault:e instanceof Error?e.message:String(e)}),console.error(e)}render(){return this.state.fault===""?this.props.children:p("div",{class:"banner",role:"alert",children:[p("p",{children:A("fault",{reason:this.state.fault})}),p("button",{type:"button",onClick:()=>location.reload(),children:A("fault.reload")})]})}};var NS=["cell","building","runs","audit","health"];function km(){return p("header",{class:"top",children:[p("h1",{class:"project",children:[p("img",{src:"/static/icon.svg",alt:"",width:"28",height:"28"}),p("span",{children:Qe.value?.project??A("app.name")})]}),p(US,{}),p(OS,{}),p("p",{class:"who",children:dn.value!==null&&p(kt,{children:[dn.value.who," ",p("span",{class:"soft",children:dn.value.role})]})}),p("label",{class:"language",children:[p("span",{class:"unseen",children:A("language")}),p("select",{value:Gt.value,onChange:n=>sf(n.currentTarget.value),children:Object.entries(rh).map(([n,e])=>p("option",{value:n,lang:n,children:e},n))})]}),p("nav",{"aria-label":A("nav.label"),children:NS.map(n=>p("button",{type:"button","aria-current":Xt.value===n?"page":void 0,onClick:()=>Xt.value=n,children:A(`nav.${n}`)},n))})]})}function US(){let n=Ye.value,e=ct.value==="lost";return p("p",{class:`headline ${e?"":n?.phase??""}`,role:"status",children:!e&&n!==null&&p(kt,{children:[p("b",{children:A(`phase.${n.phase}`)}),p("span",{class:"soft",children:A("progress",{...n.progress})}),n.phase==="waiting"&&et.value!==null&&p("code",{class:"code",children:et.value.code})]})})}function OS(){let n=Ye.value?.cell==="absent"&&ct.value!=="lost",e=n?A("link.absent"):A(`link.${ct.value}`,{seconds:Dt(Es.value,1)});return p("p",{class:`chip ${n?"stale":ct.value}`,"data-link":ct.value,children:[p("span",{class:"dot","aria-hidden":"true"}),e]})}var Uu=["#2f6f9f","#b5651d","#4d7f3d","#7a569b","#9c4657","#3a7d7d"];function vc(n){return Uu[n%Uu.length]??Uu[0]}var Ou=["#7ba1c0","#d09a5f","#8db37e","#ad94c2","#c68a95","#7fb0b0"];function zm(n){return Ou[n%Ou.length]??Ou[0]}var We={target:"#4f8cc6",active:"#0f7d8c",material:"#c6a06c",accessible:"#e6bf7f",built:"#b5874b",underWay:"#e8a93e",designed:"#98a3ab",keepOut:"#c9543f",wrong:"#b3261e",selected:"#0b93a5",blocker:"#d3321f",stale:"#a3abb0",fixture:"#cfd2d0",floor:"#dfe0dc",tool:"#54606a",path:"#0b93a5"};function Fu(n){return n.layer==="virtual_collision"?"keepOut":n.layer==="material"||n.layer==="as_built"?"solid":"ghost"}var FS=new Set(["refused","needs-rework","stray"]);function Gm(n){if(FS.has(n.status))return We.wrong;switch(n.layer){case"target":return n.status==="active"?We.active:We.target;case"material":return n.status==="held"||n.status==="used"?We.underWay:n.accessible?We.accessible:We.material;case"as_built":return We.built;case"as_designed":return We.designed;case"virtual_collision":return We.keepOut}}function Vm(n){if(n==="solid")return new Xi({color:16777215});let e=n==="ghost"?.2:.06;return new Xi({color:16777215,transparent:!0,opacity:e,depthWrite:!1,side:yn})}function Hm(n){let e={solid:"#5a4220",ghost:We.target,keepOut:We.keepOut}[n];return new Si({color:e,transparent:!0,opacity:n==="solid"?.5:.85})}var ti=n=>new Xi({color:new Oe(n)}),li=(n,e)=>new Xi({color:new Oe(n),transparent:!0,opacity:e,depthWrite:!1});var BS=new P(1,1,1);function Tt(n,e=new qe){let[t,i,s,r]=n.q_wxyz;return e.compose(new P(...n.p_m),new rn(i,s,r,t),BS)}var kS=ti(We.blocker),Wm=li(We.blocker,.72),Xm=li(We.underWay,.42),zS={arm:()=>Xm,tool:Xm},GS=li(We.stale,.14),VS=li(We.underWay,.55),qm=.7,yc=class{constructor(e,{pair:t,posture:i}){this.cell=e;let{ghosts:s,live:r}=e;s.setLook(zS),s.setAsDocumented();let o=i?.q_rad??{};for(let a of i?.bodies??[])s.attach(a.body,a.on,a.pose);for(let[a,c]of Object.entries(o)){s.setPosture(a,c);let l=r.tools.get(r.endEffectorOn(a)?.id??"");for(let h of[...r.arms.get(a)?.meshes??[],...l?.meshes??[]])this.paint(h,GS)}s.setShown(a=>a in o),s.root.visible=i!==null,s.root.updateMatrixWorld(!0),this.placeBodies(i,new Set(t));for(let a of t)this.light(a,o)}cell;root=new pt;lit=new Set;names=[];placed=new Set;found=[];before=new Map;get postures(){let{ghosts:e}=this.cell;return Object.fromEntries([...e.arms].filter(([,t])=>t.root.visible&&e.root.visible).map(([t,i])=>[t,i.joints]))}get box(){return WS(this.found)}putAway(){this.root.removeFromParent();for(let[e,t]of this.before)e.material=t}paint(e,t){this.before.has(e)||this.before.set(e,e.material),e.material=t}placeBodies(e,t){for(let{body:i,on:s,pose:r}of e?.bodies??[]){let o=this.cell.scene.components.find(l=>l.id===i)?.geometry;if(o==null)continue;let a=s===null?Tt(r):this.cell.ghosts.tipOf(s).multiply(Tt(r)),c=new mt(this.cell.shapes.solid(o),t.has(i)?Wm:VS);c.applyMatrix4(a),c.raycast=()=>{},this.root.add(c),this.placed.add(i),t.has(i)&&this.found.push(new Ut().setFromObject(c))}}light(e,t){let[i="",s]=e.split("/"),r=[...this.lightMeshes(i,s,t),...this.lightPiece(i)];this.found.push(...r),(r.length>0||this.placed.has(i))&&this.names.push(e)}lightMeshes(e,t,i){let{ghosts:s,live:r,still:o}=this.cell,a=(e in i?s:r).arms.get(e),l=(Object.keys(i).some(d=>s.endEffectorOn(d)?.id===e)?s:r).tools.get(e),h=(a??l)?.meshes.filter(d=>a===void 0||t===void 0||d.name===t)??[],f=(o.getObjectByName(e)?.children??[]).filter(d=>d instanceof mt);for(let d of h)this.paint(d,kS);for(let d of f)this.paint(d,Wm);return[...h,...f].map(d=>new Ut().setFromObject(d))}lightPiece(e){let{scene:t,shapes:i,pieces:s}=this.cell,r=s.poseOf(e),o=t.components.find(a=>a.id===e)?.geometry;return this.placed.has(e)||r===void 0||o==null?[]:(this.lit.add(e),[HS(i,o,r)])}};function HS(n,e,t){let i=n.solid(e);return i.computeBoundingBox(),(i.boundingBox??new Ut).clone().applyMatrix4(t)}function WS(n){let[e]=[...n].sort((s,r)=>s.getSize(new P).length()-r.getSize(new P).length());if(e===void 0)return null;let t=e.clone().expandByScalar(qm),i=e.clone();for(let s of n)s.intersectsBox(t)&&i.union(s.clone().intersect(t));return i.expandByScalar(qm/2)}function Bu(n){return n.components.filter(e=>e.layer==="target"||e.layer==="as_built").map(e=>({...e,layer:"as_built"}))}function ku(n){let e=new Ut;for(let t of n.robots)e.expandByPoint(new P(...t.world_T_base.p_m));for(let{world_T:t}of n.components)t!==null&&e.expandByPoint(new P(...t.p_m));return e}function Ym(n){let e=new Ut;for(let{world_T:t}of n)t!==null&&e.expandByPoint(new P(...t.p_m));return e.isEmpty()?new Ut(new P(-1,-1,0),new P(1,1,1)):e.expandByScalar(1)}function zu(n,e){let t=e.clone();for(let i of n.robots){let s=new P(...i.world_T_base.p_m);t.expandByPoint(s.clone().add(new P(0,0,2.1)))}return t.expandByVector(new P(.35,.25,0))}var XS=new qe().makeScale(0,0,0),Ls=class{root=new pt;slots=new Map;poses=new Map;hidden=new Set;lit=new Map;constructor(e,t){let i=new Map;for(let s of e){if(s.geometry===null||s.world_T===null)continue;let r=`${Fu(s)}/${s.geometry}`;i.set(r,[...i.get(r)??[],s])}for(let s of i.values())this.addBatch(s,t)}has(e){return this.slots.has(e)}poseOf(e){return this.poses.get(e)}seenPoseOf(e){return this.hidden.has(e)?void 0:this.poses.get(e)}setPose(e,t){this.poses.set(e,t.clone()),this.place(e)}setShown(e){for(let[t,i]of this.slots){let s=i.batch.members[i.index];s!==void 0&&(e(s)?this.hidden.delete(t):this.hidden.add(t),this.place(t))}}setLit(e){let t=new Set([...this.lit.keys(),...e.keys()]);this.lit.clear();for(let[i,s]of e)this.lit.set(i,s);for(let i of t)this.paint(i)}componentAt(e){let t=[...this.slots.values()].find(i=>i.batch.mesh===e.object)?.batch;return e.instanceId===void 0?void 0:t?.members[e.instanceId]}get meshes(){return[...new Set([...this.slots.values()].map(e=>e.batch.mesh))]}dispose(){for(let e of this.meshes)e.dispose()}addBatch(e,t){let i=e[0];if(i?.geometry==null)return;let s=Fu(i),r=new io(t.solid(i.geometry),Vm(s),e.length);r.castShadow=r.receiveShadow=s==="solid",r.renderOrder=s==="solid"?0:1,r.frustumCulled=!1;let o={mesh:r,members:e};e.forEach((a,c)=>{this.slots.set(a.id,{batch:o,index:c}),a.world_T!==null&&this.poses.set(a.id,Tt(a.world_T)),this.place(a.id),this.paint(a.id)}),this.root.add(r,qS(r,i,s,t))}place(e){let t=this.slots.get(e),i=this.poses.get(e);t===void 0||i===void 0||(t.batch.mesh.setMatrixAt(t.index,this.hidden.has(e)?XS:i),t.batch.mesh.instanceMatrix.needsUpdate=!0,t.batch.mesh.boundingSphere=null)}paint(e){let t=this.slots.get(e),i=t?.batch.members[t.index];t===void 0||i===void 0||(t.batch.mesh.setColorAt(t.index,new Oe(this.lit.get(e)??Gm(i))),t.batch.mesh.instanceColor!==null&&(t.batch.mesh.instanceColor.needsUpdate=!0))}};function qS(n,e,t,i){if(e.geometry===null)throw new Error(`${e.id} has no shape`);let s=new Hi(i.edge(e.geometry),Hm(t));return Object.assign(s,{isInstancedMesh:!0,instanceMatrix:n.instanceMatrix,instanceColor:null,morphTexture:null,count:n.count}),s.frustumCulled=!1,s.raycast=()=>{},s.renderOrder=2,s}var YS=20,Sr=class{constructor(e){this.records=e}records;solids=new Map;edges=new Map;solid(e){let t=this.solids.get(e);return t===void 0&&(t=ZS(this.record(e)),this.solids.set(e,t)),t}edge(e){let t=this.edges.get(e);return t===void 0&&(t=new lo(this.solid(e),YS),this.edges.set(e,t)),t}dispose(){for(let e of[...this.solids.values(),...this.edges.values()])e.dispose()}record(e){let t=this.records[e];if(t===void 0)throw new Error(`the scene has no geometry ${e}`);return t}};function ZS(n){let e=new Float32Array(n.triangles.length*9);n.triangles.flat().forEach((i,s)=>{let r=n.corners_m[i];if(r===void 0)throw new Error(`a triangle names corner ${i}, which is not there`);e.set(r,s*3)});let t=new Sn;return t.setAttribute("position",new Pn(e,3)),t.computeVertexNormals(),t.computeBoundingSphere(),t}var Zm={type:"change"},Vu={type:"start"},jm={type:"end"},xc=new Gi,$m=new Cn,$S=Math.cos(70*gr.DEG2RAD),Yt=new P,wn=2*Math.PI,st={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Gu=1e-6,bc=class extends bo{constructor(e,t=null){super(e,t),this.state=st.NONE,this.target=new P,this.cursor=new P,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$i.ROTATE,MIDDLE:$i.DOLLY,RIGHT:$i.PAN},this.touches={ONE:ji.ROTATE,TWO:ji.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new P,this._lastQuaternion=new rn,this._lastTargetPosition=new P,this._quat=new rn().setFromUnitVectors(e.up,new P(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new hr,this._sphericalDelta=new hr,this._scale=1,this._panOffset=new P,this._rotateStart=new ye,this._rotateEnd=new ye,this._rotateDelta=new ye,this._panStart=new ye,this._panEnd=new ye,this._panDelta=new ye,this._dollyStart=new ye,this._dollyEnd=new ye,this._dollyDelta=new ye,this._dollyDirection=new P,this._mouse=new ye,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=JS.bind(this),this._onPointerDown=jS.bind(this),this._onPointerUp=KS.bind(this),this._onContextMenu=rM.bind(this),this._onMouseWheel=tM.bind(this),this._onKeyDown=nM.bind(this),this._onTouchStart=iM.bind(this),this._onTouchMove=sM.bind(this),this._onMouseDown=QS.bind(this),this._onMouseMove=eM.bind(this),this._interceptControlDown=oM.bind(this),this._interceptControlUp=aM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=st.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Zm),this.update(),this.state=st.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Yt.copy(t).sub(this.target),Yt.applyQuaternion(this._quat),this._spherical.setFromVector3(Yt),this.autoRotate&&this.state===st.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=wn:i>Math.PI&&(i-=wn),s<-Math.PI?s+=wn:s>Math.PI&&(s-=wn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Yt.setFromSpherical(this._spherical),Yt.applyQuaternion(this._quatInverse),t.copy(this.target).add(Yt),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Yt.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new P(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new P(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Yt.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(xc.origin.copy(this.object.position),xc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(xc.direction))<$S?this.object.lookAt(this.target):($m.setFromNormalAndCoplanarPoint(this.object.up,this.target),xc.intersectPlane($m,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Gu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Gu||this._lastTargetPosition.distanceToSquared(this.target)>Gu?(this.dispatchEvent(Zm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?wn/60*this.autoRotateSpeed*e:wn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Yt.setFromMatrixColumn(t,0),Yt.multiplyScalar(-e),this._panOffset.add(Yt)}_panUp(e,t){this.screenSpacePanning===!0?Yt.setFromMatrixColumn(t,1):(Yt.setFromMatrixColumn(t,0),Yt.crossVectors(this.object.up,Yt)),Yt.multiplyScalar(e),this._panOffset.add(Yt)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Yt.copy(s).sub(this.target);let r=Yt.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wn*this._rotateDelta.x/t.clientHeight),this._rotateUp(wn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(wn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-wn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(wn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-wn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wn*this._rotateDelta.x/t.clientHeight),this._rotateUp(wn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new ye,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function jS(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function JS(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function KS(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(jm),this.state=st.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function QS(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case $i.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=st.DOLLY;break;case $i.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=st.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=st.ROTATE}break;case $i.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=st.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=st.PAN}break;default:this.state=st.NONE}this.state!==st.NONE&&this.dispatchEvent(Vu)}function eM(n){switch(this.state){case st.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case st.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case st.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function tM(n){this.enabled===!1||this.enableZoom===!1||this.state!==st.NONE||(n.preventDefault(),this.dispatchEvent(Vu),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(jm))}function nM(n){this.enabled!==!1&&this._handleKeyDown(n)}function iM(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ji.ROTATE:if(this.enableRotate===!1){this.state=st.NONE;break}this._handleTouchStartRotate(n),this.state=st.TOUCH_ROTATE;break;case ji.PAN:if(this.enablePan===!1){this.state=st.NONE;break}this._handleTouchStartPan(n),this.state=st.TOUCH_PAN;break;default:this.state=st.NONE}break;case 2:switch(this.touches.TWO){case ji.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=st.TOUCH_DOLLY_PAN;break;case ji.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=st.TOUCH_DOLLY_ROTATE;break;default:this.state=st.NONE}break;default:this.state=st.NONE}this.state!==st.NONE&&this.dispatchEvent(Vu)}function sM(n){switch(this._trackPointer(n),this.state){case st.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case st.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case st.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case st.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=st.NONE}}function rM(n){this.enabled!==!1&&n.preventDefault()}function oM(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function aM(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Jm={whole:new P(.62,-1,.62),top:new P(0,-1e-4,1),front:new P(0,-1,.12),side:new P(1,0,.12)},Sc=class{eye=new hn(30,1,.05,120);controls;bounds=new Ut(new P(-2,-2,0),new P(2,2,2));constructor(e,t){this.eye.up.set(0,0,1),this.controls=new bc(this.eye,e),this.controls.enableDamping=!1,this.controls.maxPolarAngle=gr.degToRad(96),this.controls.minDistance=.4,this.controls.maxDistance=40,this.controls.addEventListener("change",t)}resize(e,t){this.eye.aspect=e/Math.max(t,1),this.eye.updateProjectionMatrix()}setBounds(e){this.bounds=e}look(e){let t=this.bounds.getCenter(new P);this.from(Jm[e],t,this.distance(Jm[e]))}frame(e){let t=this.eye.position.clone(),i=this.controls.target.clone(),s=this.bounds,r=t.clone().sub(i);return this.bounds=e,this.from(r,e.getCenter(new P),this.distance(r)),this.bounds=s,()=>{this.eye.position.copy(t),this.controls.target.copy(i),this.controls.update()}}lookFrom(e){let t=this.bounds.getCenter(new P),s=e.clone().sub(t).setZ(0).normalize().multiplyScalar(1).setZ(.55);this.from(s,t,this.distance(s)*.86)}follow(e){let t=e.clone().sub(this.controls.target).multiplyScalar(1);this.eye.position.add(t),this.controls.target.add(t),this.controls.update()}from(e,t,i){this.controls.target.copy(t),this.eye.position.copy(e).normalize().multiplyScalar(i).add(t),this.controls.update()}distance(e){let t=this.bounds.getCenter(new P),i=new hn(this.eye.fov,this.eye.aspect);i.up.set(0,0,1),i.position.copy(e).normalize().add(t),i.lookAt(t),i.updateMatrixWorld();let s=Math.tan(gr.degToRad(this.eye.fov/2)),r=s*this.eye.aspect,{min:o,max:a}=this.bounds,c=1;for(let l of[o.x,a.x])for(let h of[o.y,a.y])for(let f of[o.z,a.z]){let d=new P(l,h,f).applyMatrix4(i.matrixWorldInverse);c=Math.max(c,d.z+1+Math.abs(d.x)/r,d.z+1+Math.abs(d.y)/s)}return c*.94}dispose(){this.controls.dispose()}};Vt.DEFAULT_UP.set(0,0,1);var Mc=class{constructor(e,t,i){this.canvas=e;this.frame=t;this.renderer=new ac({canvas:e,antialias:!0,alpha:!0,preserveDrawingBuffer:!1}),this.renderer.setPixelRatio(i),this.renderer.toneMapping=Vn,this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=xs,this.camera=new Sc(e,()=>this.ask()),this.world.add(new go(16777215,13882060,1.95),this.sun,this.sun.target),this.resizer=new ResizeObserver(()=>this.resize()),this.resizer.observe(t),e.addEventListener("pointerdown",this.press),e.addEventListener("pointerup",this.lift),e.addEventListener("webglcontextrestored",()=>this.ask()),this.resize()}canvas;frame;world=new Kr;camera;cost={js_ms:0,calls:0};onDrawn=()=>{};onTap=()=>{};renderer;sun=new yo(16775922,2);resizer;asked=0;pressed=null;setBounds(e){this.camera.setBounds(e);let t=e.getCenter(new P),i=e.getSize(new P).length()/2;this.sun.position.copy(t).add(new P(-.55,-.75,1.3).multiplyScalar(i*1.6)),this.sun.target.position.copy(t),this.sun.target.updateMatrixWorld(),this.sun.castShadow=!0;let s=this.sun.shadow;s.mapSize.set(1536,1536),Object.assign(s.camera,{left:-i,right:i,top:i,bottom:-i,near:.1,far:i*4}),s.camera.updateProjectionMatrix(),s.bias=-6e-4,s.normalBias=.02,s.intensity=.45,this.ask()}ask(){this.asked===0&&(this.asked=requestAnimationFrame(()=>{this.asked=0,this.draw()}))}draw(){let e=performance.now();this.renderer.render(this.world,this.camera.eye),this.cost.js_ms=performance.now()-e,this.cost.calls=this.renderer.info.render.calls,this.onDrawn()}pixels(){return this.draw(),this.canvas.toDataURL()}project(e){this.camera.eye.updateMatrixWorld();let t=e.clone().project(this.camera.eye);if(t.z>1)return null;let i=this.canvas.getBoundingClientRect();return{x:(t.x+1)/2*i.width,y:(1-t.y)/2*i.height}}dispose(){cancelAnimationFrame(this.asked),this.resizer.disconnect(),this.camera.dispose(),this.renderer.dispose()}resize(){let{clientWidth:e,clientHeight:t}=this.frame;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera.resize(e,t),this.ask())}press=e=>{this.pressed={x:e.clientX,y:e.clientY}};lift=e=>{let t=this.pressed;if(this.pressed=null,t===null||Math.hypot(e.clientX-t.x,e.clientY-t.y)>6)return;let i=this.canvas.getBoundingClientRect(),s=new ye((e.clientX-i.left)/i.width*2-1,1-(e.clientY-i.top)/i.height*2),r=new xo;r.setFromCamera(s,this.camera.eye),this.onTap(r.intersectObjects(this.world.children,!0))}};var lM=li(We.blocker,.6),cM={tool:"#7d5ba6",buffer:"#5b8c4a",preparation:"#6f7f8b",stock:"#a67c3d"};function Qm(n,e){let t=new pt,i=ti(We.fixture),s=ti(We.floor),r=new Si({color:"#8d938f",transparent:!0,opacity:.5});for(let l of n.fixtures){if(l.geometry===null)continue;let h=new mt(e.solid(l.geometry),Km(l.id)?s:i);h.receiveShadow=!0,h.castShadow=!Km(l.id);let f=new Hi(e.edge(l.geometry),r),d=new pt().add(h,f);d.applyMatrix4(Tt(l.world_T)),d.name=l.id,t.add(d)}let o=hM(We.keepOut,n.ground_z_m),a=new Si({color:We.keepOut,transparent:!0,opacity:.35});for(let l of n.zones){if(l.geometry===null)continue;let h=new mt(e.solid(l.geometry),o);h.renderOrder=3;let f=new pt().add(h,new Hi(e.edge(l.geometry),a));f.applyMatrix4(Tt(l.world_T)),f.name=l.id,f.userData.isZone=!0,t.add(f)}let c=[...n.stations,...n.stock_places.map(l=>({...l,kind:"stock"}))];for(let l of c){let h=uM(l);h!==null&&t.add(h)}return t}function eg(n,e){for(let t of n.children)for(let i of t.children)i instanceof mt&&(i.userData.own??=i.material,i.material=e.has(t.name)?lM:i.userData.own)}var Km=n=>n==="floor"||n==="ground";function hM(n,e){return new Gn({uniforms:{colour:{value:new Oe(n)},foot:{value:e}},vertexShader:"varying vec3 p; void main(){ vec4 w = modelMatrix * vec4(position,1.0); p = w.xyz; gl_Position = projectionMatrix * viewMatrix * w; }",fragmentShader:"varying vec3 p; uniform vec3 colour; uniform float foot; void main(){ float s = fract((p.x + p.y + p.z) * 2.5); float low = 1.0 - smoothstep(0.0, 0.9, p.z - foot); gl_FragColor = vec4(colour, (s < 0.3 ? 0.30 : 0.05) * (0.16 + 0.84 * low)); }",transparent:!0,depthWrite:!1,side:yn})}function uM(n){let e="kind"in n?n.kind:"";if(e==="preparation")return null;let t=new vs({color:cM[e]??"#6f7f8b",transparent:!0,opacity:.75,side:yn,depthWrite:!1}),i=new mt(new uo(.09,.12,40),t);return i.applyMatrix4(Tt(n.world_T)),i.translateZ(.004),i.renderOrder=2,i}function tg(n){let e=document.createElement("canvas");e.width=e.height=256;let t=e.getContext("2d");if(t!==null){let r=t.createRadialGradient(128,128,20,128,128,128);r.addColorStop(0,"rgba(214,214,206,1)"),r.addColorStop(1,"rgba(214,214,206,0)"),t.fillStyle=r,t.fillRect(0,0,256,256)}let i=new ro(e);i.wrapS=i.wrapT=tr;let s=new mt(new ys(26,26),new vs({map:i,transparent:!0,depthWrite:!1}));return s.position.z=n-.002,s.renderOrder=-1,s}var wc=class{constructor(e,t,i){this.replay=e;this.pieces=new Ls(t.components.map(s=>fM(s,e)),i)}replay;pieces;sensed=null;isWished=()=>!0;lit=new Map;show(e,t){this.sensed=this.replay.pose(e,t,this.pieces),this.refresh()}setShown(e){this.isWished=e,this.refresh()}setLit(e){this.lit=e,this.refresh()}refresh(){let{sensed:e}=this;if(e===null)return;this.pieces.setShown(r=>this.isWished(r)&&dM(r,e));let t=[...e.placed.values()].map(r=>[r,We.built]),i=[...e.robots.values()].flatMap(r=>r.gripped===null?[]:[[r.gripped,We.underWay]]),s=[...this.lit].map(([r,o])=>[e.placed.get(r)??r,o]);this.pieces.setLit(new Map([...t,...i,...s]))}};function dM(n,e){return n.layer==="material"?e.pieces.has(n.id):n.layer!=="target"||!e.placed.has(n.id)}function fM(n,{record:e}){if(n.layer==="material"){let i=e.start.pieces[n.id]??e.moments.find(s=>n.id in s.pieces)?.pieces[n.id];return{...n,status:"stock",accessible:!1,world_T:i??n.world_T}}return n.layer==="as_built"&&n.made_of!==null||n.layer==="target"?{...n,layer:"target",status:"waiting"}:n}var Mr=class{root=new pt;tip;meshes=[];axes=[];turn=new rn;move=new qe;constructor(e,t,i){let s=new Map([[e.root,this.root]]);for(let r of e.joints){let o=s.get(r.parent);if(o===void 0)throw new Error(`joint ${r.name} comes before its parent ${r.parent}`);let a=new pt;a.matrixAutoUpdate=!1,Tt(r.parent_T_joint,a.matrix),o.add(a),s.set(r.child,a),r.kind!=="fixed"&&this.axes.push({record:r,node:a,rest:a.matrix.clone(),axis:new P(...r.axis)})}for(let r of e.links){if(r.geometry===null)continue;let o=new mt(t.solid(r.geometry),i);o.name=r.name,o.castShadow=o.receiveShadow=!0,s.get(r.name)?.add(o),this.meshes.push(o)}this.root.matrixAutoUpdate=!1,this.tip=s.get(e.tip)??this.root}get jointCount(){return this.axes.length}get foot(){return this.axes.find(e=>e.record.kind==="revolute")?.node.parent??this.root}setJoints(e){let t=[];return this.axes.forEach((i,s)=>{let r=e[s]??0;i.record.kind==="revolute"?this.move.makeRotationFromQuaternion(this.turn.setFromAxisAngle(i.axis,r)):this.move.makeTranslation(i.axis.x*r,i.axis.y*r,i.axis.z*r),i.node.matrix.multiplyMatrices(i.rest,this.move),i.node.matrixWorldNeedsUpdate=!0,(r<i.record.lower_rad-1e-4||r>i.record.upper_rad+1e-4)&&t.push(i.record.name)}),t}setMaterial(e){for(let t of this.meshes)t.material=e}};var Tc=class{constructor(e,t,i){this.record=e;this.body=new Mr(e.description,t,i),Tt(e.world_T_base,this.root.matrix),this.root.matrixAutoUpdate=!1,this.root.add(this.body.root)}record;root=new pt;body;isOffLimits=!1;joints=[];get tip(){return this.body.tip}get meshes(){return this.body.meshes}setPosture(e){this.joints=Array.from(e),this.isOffLimits=this.body.setJoints(e).length>0,this.root.updateMatrixWorld(!0)}};var pM=n=>n.joints.filter(e=>e.kind!=="fixed").length,ko=class{constructor(e,t,i){this.scene=e;e.robots.forEach((s,r)=>{let o=new Tc(s,t,i.arm(r));this.arms.set(s.id,o),this.root.add(o.root)});for(let s of e.end_effectors)this.tools.set(s.id,new Mr(s.description,t,i.tool));this.setAsDocumented()}scene;root=new pt;arms=new Map;tools=new Map;setLook(e){this.scene.robots.forEach((t,i)=>this.arms.get(t.id)?.body.setMaterial(e.arm(i)));for(let t of this.tools.values())t.setMaterial(e.tool)}setShown(e){for(let[i,s]of this.arms)s.root.visible=e(i);let t=new Set([...this.arms.values()].map(i=>i.tip));for(let i of this.tools.values())i.root.visible=i.root.parent!==null&&t.has(i.root.parent)||this.scene.robots.every(s=>e(s.id))}setAsDocumented(){for(let e of this.scene.end_effectors)this.attach(e.id,e.on,e.world_T_mount);for(let e of this.scene.robots)this.arms.get(e.id)?.setPosture(e.q_rad);for(let e of this.scene.end_effectors)this.setTool(e.id,e.q)}attach(e,t,i){let s=this.tools.get(e);if(s===void 0)return;let r=t===null?void 0:this.arms.get(t)?.tip;s.root.removeFromParent(),r!==void 0?(s.root.matrix.identity(),r.add(s.root)):i!==null&&(Tt(i,s.root.matrix),this.root.add(s.root)),s.root.matrixWorldNeedsUpdate=!0}setPosture(e,t){this.arms.get(e)?.setPosture(t)}setTool(e,t){this.tools.get(e)?.setJoints(t)}setJoints(e){let t=0;for(let i of[...this.scene.robots,...this.scene.end_effectors]){let s=Array.from({length:pM(i.description)},(r,o)=>e[t+o]??0);t+=s.length,this.arms.has(i.id)?this.setPosture(i.id,s):this.setTool(i.id,s)}}tipOf(e){let t=this.arms.get(e);if(t===void 0)throw new Error(`the scene has no robot ${e}`);return t.root.updateMatrixWorld(!0),t.tip.matrixWorld.clone()}tcpOf(e){let t=this.arms.get(e)?.tip;for(let i of this.tools.values())if(t!==void 0&&i.root.parent===t)return t.updateWorldMatrix(!0,!0),i.tip.matrixWorld.clone();return this.tipOf(e)}endEffectorOn(e){let t=this.arms.get(e)?.tip;return this.scene.end_effectors.find(i=>this.tools.get(i.id)?.root.parent===t)}};var ng=ti(We.tool),Hu={arm:n=>ig[n%ig.length]??ng,tool:ng},ig=Array.from({length:6},(n,e)=>ti(zm(e))),sg=ti(We.stale),mM={arm:()=>sg,tool:sg},rg=li(We.path,.32),og={arm:()=>rg,tool:rg},gM=ti(We.path),_M=ti(We.blocker),ag=new Set,Ec=class{stage;onPick=()=>{};onGround=()=>{};scene=null;parts=new pt;zones=[];shapes=new Sr({});live=null;rehearsed=null;pieces=null;building=null;rehearsal=null;then=null;still=new pt;refused=null;clash=null;comeBack=null;lit=new Map;litThings=ag;path=new mt(void 0,gM);draft=new mt(new Wi(1,1,1),li(We.keepOut,.35));mode="now";time_s=0;step=null;isStale=!1;followed=null;isShown=()=>!0;sensed=new Map;constructor(e,t,i){this.stage=new Mc(e,t,i),this.stage.onTap=s=>this.pick(s),this.path.raycast=()=>{},this.path.visible=!1,this.draft.raycast=()=>{},this.draft.visible=!1,this.stage.world.add(this.path,this.draft)}setScene(e){let t=this.scene===null;this.clear(),this.scene=e,this.shapes=new Sr(e.geometries),this.live=new ko(e,this.shapes,Hu),this.rehearsed=new ko(e,this.shapes,og),this.rehearsed.root.traverse(s=>{s.raycast=()=>{}}),this.pieces=new Ls(e.components,this.shapes),this.building=new Ls(Bu(e),this.shapes),this.still=Qm(e,this.shapes),this.zones=this.still.children.filter(s=>s.userData.isZone===!0),this.parts=new pt().add(this.still,this.live.root,this.rehearsed.root,this.pieces.root,this.building.root),this.stage.world.add(this.parts);let i=ku(e);this.parts.add(tg(e.ground_z_m)),this.stage.setBounds(zu(e,i)),t&&this.stage.camera.look("whole"),this.refresh()}get team(){return this.rehearsed}get sensedPoses(){let e=this.scene?.components.flatMap(t=>t.world_T===null?[]:[[t.id,Tt(t.world_T)]])??[];return new Map([...e,...this.sensed])}setJoints(e){this.live?.setJoints(e),this.followed!==null&&this.live!==null&&this.mode==="now"&&this.stage.camera.follow(new P().setFromMatrixPosition(this.live.tcpOf(this.followed))),this.stage.ask()}setSensedPoses(e){let t=[...this.sensed.keys()].filter(s=>!e.has(s));this.sensed.clear();for(let[s,r]of e)this.sensed.set(s,r);if(this.mode==="preview"||this.mode==="replay")return;let i=new Map(this.scene?.components.map(s=>[s.id,s]));for(let s of t){let r=i.get(s);r?.world_T!=null&&this.pieces?.setPose(s,Tt(r.world_T))}for(let[s,r]of e)this.pieces?.setPose(s,r);this.stage.ask()}setStale(e){e!==this.isStale&&(this.isStale=e,this.refresh())}setMode(e){this.mode=e,this.refresh()}setFilter(e){this.isShown=e,this.refresh()}setLit(e){this.lit=e,this.pieces?.setLit(e),this.building?.setLit(e),this.then?.setLit(e),this.stage.ask()}setRehearsal(e){this.rehearsal=e,this.refresh()}setReplay(e){this.then!==null&&(this.parts.remove(this.then.pieces.root),this.then.pieces.dispose()),this.then=e===null||this.scene===null?null:new wc(e,this.scene,this.shapes),this.then!==null&&this.parts.add(this.then.pieces.root),this.then?.setLit(this.lit),this.refresh()}setStep(e){this.step=e,this.drawPath(),this.refresh()}setTime(e){this.time_s=e,(this.mode==="preview"||this.mode==="replay")&&this.poseRehearsal(),this.stage.ask()}setRefused(e){this.refused=e,this.comeBack?.(),this.comeBack=null,this.refresh();let t=this.clash===null||this.mode!=="now"?null:this.clash.box;t!==null&&(this.comeBack=this.stage.camera.frame(t))}get shownRefused(){return this.clash}setLitThings(e){this.litThings=e,this.refresh()}postures(){return this.scene?.robots.map(e=>this.live?.arms.get(e.id)?.joints??[])??[]}setDraft(e){this.draft.visible=e!==null,e!==null&&(this.draft.position.set(...e.centre),this.draft.scale.set(...e.size)),this.stage.ask()}look(e){this.followed=null,this.stage.camera.look(e)}lookAtBuilding(e){if(this.scene===null)return;let t=e?Ym(Bu(this.scene)):zu(this.scene,ku(this.scene));this.stage.camera.setBounds(t),this.look("whole")}lookFromRobot(e){this.followed=null;let t=this.scene?.robots.find(i=>i.id===e);t!==void 0&&this.stage.camera.lookFrom(new P(...t.world_T_base.p_m))}follow(e){this.followed=e}placeOf(e){let t=this.shownPieces?.seenPoseOf(e);return t===void 0?null:new P().setFromMatrixPosition(t).toArray()}get shownPieces(){return this.mode==="replay"?this.then?.pieces??null:this.pieces}project(e){let t=this.shownPieces?.poseOf(e);return t===void 0?null:this.stage.project(new P().setFromMatrixPosition(t))}tags(){if(this.mode==="target"||this.mode==="as-built")return[];let e=this.mode==="preview"||this.mode==="replay"?this.rehearsed:this.live;return(this.scene?.robots??[]).flatMap(t=>{if(e===null)return[];let i=e.arms.get(t.id)?.body.foot;if(i===void 0)return[];let s=this.stage.project(new P().setFromMatrixPosition(i.matrixWorld).add(new P(0,0,.12)));return s===null?[]:[{id:t.id,number:t.number,...s}]})}dispose(){this.clear(),this.stage.dispose()}refresh(){let{live:e,rehearsed:t,pieces:i}=this;if(e===null||t===null||i===null)return;let s=this.mode==="replay"&&this.then!==null,r=this.mode==="preview"||s,o=this.mode==="target"||this.mode==="as-built";this.putClashAway(),e.root.visible=!r&&!o,e.setLook(this.isStale?mM:Hu);let a=this.refused===null?this.litThings:ag;if(eg(this.still,a),!this.isStale)for(let c of a)e.arms.get(c)?.body.setMaterial(_M);t.setLook(r?Hu:og),t.root.traverse(c=>{c.castShadow=r}),i.root.visible=this.mode!=="target"&&!s,this.then!==null&&(this.then.pieces.root.visible=s,this.then.setShown(this.isShown)),i.setShown(c=>this.isShown(c)&&vM(c,this.mode)),this.building?.setShown(this.isShown);for(let c of this.zones)c.visible=this.mode!=="target";this.building!==null&&(this.building.root.visible=this.mode==="target");for(let[c,l]of this.sensedPoses)i.setPose(c,l);this.path.visible=this.step!==null&&this.path.geometry.attributes.position!==void 0&&!o&&!s,this.poseRehearsal(),this.stage.ask()}poseRehearsal(){let{rehearsed:e,rehearsal:t,step:i}=this;if(e===null)return;if(this.mode==="replay"&&this.then!==null){e.root.visible=!0,this.then.show(this.time_s,e),e.setShown(()=>!0);return}if(this.mode==="preview"&&t!==null){e.root.visible=!0,t.pose(this.time_s,e,this.pieces),e.setShown(()=>!0);return}if(this.mode==="now"&&this.refused!==null){this.drawClash(this.refused);return}let s=this.mode==="now"&&t!==null&&i!==null&&i.motions.length>0;e.root.visible=s||this.mode==="preview",s&&(t.pose(i.starts_s+i.duration_s,e,null),e.setShown(r=>r===i.robot))}putClashAway(){this.clash!==null&&(this.clash.putAway(),this.clash=null,this.pieces?.setLit(this.lit))}drawClash(e){let{scene:t,shapes:i,rehearsed:s,live:r,pieces:o,still:a}=this;t===null||s===null||r===null||o===null||(this.clash=new yc({scene:t,shapes:i,ghosts:s,live:r,pieces:o,still:a},e),this.parts.add(this.clash.root),o.setLit(new Map([...this.clash.lit].map(c=>[c,We.blocker]))))}drawPath(){if(this.path.geometry.dispose(),this.path.visible=!1,this.step===null||this.rehearsal===null||this.rehearsed===null)return;let e=this.rehearsal.pathOf(this.step,this.rehearsed).map(i=>new P().setFromMatrixPosition(i)),t=e.filter((i,s)=>s===0||i.distanceTo(e[s-1]??i)>1e-4);t.length<2||(this.path.geometry=new fo(new lr(t),t.length*2,.009,6),this.path.visible=!0)}pick(e){let t=e[0]?.point;t!==void 0&&this.onGround(t.x,t.y);for(let i of e){if(!lg(i.object))continue;let s=this.then?.pieces.componentAt(i)??this.pieces?.componentAt(i)??this.building?.componentAt(i);if(s!==void 0){this.onPick(s.id);return}}this.onPick(null)}clear(){this.stage.world.remove(this.parts),this.pieces?.dispose(),this.building?.dispose(),this.then?.pieces.dispose(),this.then=null,this.shapes.dispose(),this.shapes=new Sr({}),this.sensed.clear()}};function lg(n){return n===null||n.visible&&lg(n.parent)}function vM(n,e){return e==="as-built"?n.layer==="as_built"||n.layer==="virtual_collision":!0}var zo=class extends Error{};async function cg(n,e){let t=xM(await crypto.subtle.digest("SHA-256",n));if(t!==e)throw new zo(`the trajectory has the hash ${t}, the plan names ${e}`);let{robot:i,knots:s,joints:r,offset:o}=yM(new Uint8Array(n)),a=new DataView(n,o),c=1+4*r;if(a.byteLength!==s*c*8)throw new zo(`${a.byteLength} bytes are not ${s} knots of ${r} joints`);let l=(d,u)=>Number(a.getBigInt64((d*c+u)*8,!0))/1e6,h=(d,u)=>Array.from({length:r},(_,b)=>l(d,u+b)),f=Array.from({length:s},(d,u)=>u);return{robot:i,sha256:t,times_s:f.map(d=>l(d,0)),rows:f.map(d=>({q:h(d,1),v:h(d,1+r),a:h(d,1+2*r),j:h(d,1+3*r)}))}}function yM(n){let e=new TextDecoder("ascii").decode(n.subarray(0,200)),t=/^(.+?)\/(\d+)x(\d+)\//s.exec(e);if(t?.[1]===void 0)throw new zo("the trajectory has no header");return{robot:t[1],knots:Number(t[2]),joints:Number(t[3]),offset:t[0].length}}function xM(n){return[...new Uint8Array(n)].map(e=>e.toString(16).padStart(2,"0")).join("")}function Ac(n,e){let{times_s:t,rows:i}=n,s=t.length-1,r=Math.min(Math.max(bM(t,e),0),s),o=i[r];if(o===void 0)return[];if(r===s||e<=0)return o.q;let a=e-(t[r]??0);return o.q.map((c,l)=>c+a*((o.v[l]??0)+a*((o.a[l]??0)/2+a*(o.j[l]??0)/6)))}function bM(n,e){let t=0,i=n.length;for(;t<i;){let s=t+i>>1;(n[s]??0)<=e?t=s+1:i=s}return t-1}var Rc=class{constructor(e,t,i,s,r){this.proposal=e;this.trajectories=t;this.scene=i;this.start=s;this.motions=e.steps.flatMap(o=>o.motions),this.duration_s=Math.max(0,...e.steps.map(o=>o.starts_s+o.duration_s)),this.readTools(),this.readPieces(r)}proposal;trajectories;scene;start;motions;pieceKeys=[];toolKeys=[];duration_s;get hashes(){return this.motions.map(e=>this.trajectories.get(e.trajectory_sha256)?.sha256??"")}get stops(){return[...new Set([...this.proposal.steps.map(e=>e.starts_s),this.duration_s])]}postureAt(e,t){let i=this.motions.filter(a=>a.robot===e),s=i.filter(a=>a.starts_s<=t+1e-9).at(-1),r=s??i[0],o=r===void 0?void 0:this.trajectories.get(r.trajectory_sha256);return r===void 0||o===void 0?this.start.postures.get(e)??[]:Ac(o,s===void 0?0:t-r.starts_s)}pose(e,t,i){for(let s of this.scene.end_effectors)t.attach(s.id,s.on,s.world_T_mount);for(let s of this.toolKeys)s.time_s<=e+1e-9&&t.attach(s.tool,s.robot,s.pose);for(let s of this.scene.robots)t.setPosture(s.id,this.postureAt(s.id,e));if(i!==null){for(let[s,r]of this.start.poses)i.setPose(s,r);for(let s of this.pieceKeys)s.time_s<=e+1e-9&&i.setPose(s.piece,Wu(s,t))}}pathOf(e,t,i=48){return e.motions.flatMap(s=>Array.from({length:i},(r,o)=>(this.pose(s.starts_s+s.duration_s*o/(i-1),t,null),t.tcpOf(s.robot))))}readTools(){for(let e of this.motions)for(let t of e.after)this.toolKeys.push({time_s:e.starts_s+e.duration_s,tool:t.body,robot:t.on,pose:t.pose})}readPieces(e){let t=new Map;for(let i of this.proposal.steps){let s=i.holds_before?.piece;s!==void 0&&t.get(i.robot)!==s&&this.hang(i.starts_s,i,s,e);let r=i.holds_after?.piece,o=i.starts_s+i.duration_s;r!==void 0&&r!==s&&this.hang(o,i,r,e),r===void 0&&s!==void 0&&this.lay(o,i.robot,s,e),r===void 0?t.delete(i.robot):t.set(i.robot,r)}}hang(e,t,i,s){let{robot:r}=t;if(t.number<=this.start.done){this.hangBackwards(e,t,i,s);return}this.pose(e,s,null);let o=s.tipOf(r),a=this.siteOf(i,e,s);a!==void 0&&this.pieceKeys.push({time_s:e,piece:i,robot:r,pose:o.invert().multiply(a)})}hangBackwards(e,t,i,s){let{robot:r}=t,o=this.start.poses.get(i);if(o===void 0)return;let c=this.proposal.steps.filter(h=>h.robot===r&&h.number>t.number&&h.number<=this.start.done).find(h=>h.holds_before?.piece===i&&h.holds_after===null);c===void 0?s.setPosture(r,this.start.postures.get(r)??[]):this.pose(c.starts_s+c.duration_s,s,null);let l=s.tipOf(r).invert().multiply(o);this.pose(e,s,null),this.pieceKeys.push({time_s:-1,piece:i,robot:null,pose:s.tipOf(r).multiply(l)}),this.pieceKeys.push({time_s:e,piece:i,robot:r,pose:l})}lay(e,t,i,s){this.pose(e,s,null);let r=this.pieceKeys.filter(o=>o.piece===i&&o.robot===t).at(-1);r!==void 0&&this.pieceKeys.push({time_s:e,piece:i,robot:null,pose:Wu(r,s)})}siteOf(e,t,i){let s=this.pieceKeys.filter(r=>r.piece===e&&r.time_s<=t).at(-1);return s===void 0?this.start.poses.get(e)?.clone():Wu(s,i)}};function Wu(n,e){return n.robot===null?n.pose.clone():e.tipOf(n.robot).multiply(n.pose)}function hg(n){return{done:0,postures:new Map(n.robots.map(e=>[e.id,e.q_rad])),poses:new Map(n.components.flatMap(e=>e.world_T===null?[]:[[e.id,Tt(e.world_T)]]))}}var Xu=new Map;function Yu(n){let e=Xu.get(n);return e===void 0&&(e=rf(`/api/blobs/${n}`).then(t=>cg(t,n)),e.catch(()=>Xu.delete(n)),Xu.set(n,e)),e}async function SM(n,e){let t=[...new Set(n.steps.flatMap(r=>r.motions.map(o=>o.trajectory_sha256)))],i=new Map(await Promise.all(t.map(async r=>[r,await Yu(r)]))),{team:s}=e;if(Qe.value===null||s===null)throw new Error("there is no scene yet");return new Rc(n,i,Qe.value,MM(n,Qe.value,e),s)}var qu=null;function MM(n,e,t){return qu?.fingerprint!==n.fingerprint&&(qu={fingerprint:n.fingerprint,start:{...hg(e),poses:t.sensedPoses,done:n.status==="done"?1/0:n.next_step-1}}),qu.start}function ug(n){let e="";return Ze(()=>{let t=et.value,i=`${t?.fingerprint} ${Qe.value?.hash}`;i!==e&&(e=i,ai.value=null,xr.value="",!(t===null||Qe.value===null)&&SM(t,n).then(s=>{e===i&&(ai.value=s)},s=>{xr.value=s instanceof Error?s.message:String(s)}))})}function dg(){let n=0,e=0,t=i=>{let s=Cc()?.duration_s??0,r=qt.value+Math.min((i-n)/1e3,.1);n=i,Tn(Math.min(r,s)),r>=s&&(pn.value=!1),pn.value&&(e=requestAnimationFrame(t))};return Ze(()=>{cancelAnimationFrame(e),pn.value&&cs(()=>{n=performance.now(),e=requestAnimationFrame(t)})})}var Cc=()=>Dn.value??ai.value;function Tn(n){if(qt.value=n,Dn.peek()!==null)return;let t=(ai.peek()?.proposal.steps??[]).filter(i=>i.starts_s<=n+1e-6).at(-1);t!==void 0&&t.number!==Ct.peek()&&(Ct.value=t.number)}function Zu(n){let e=Cc()?.stops??[],t=qt.value,i=n>0?e.find(s=>s>t+1e-6):e.filter(s=>s<t-1e-6).at(-1);i!==void 0&&Tn(i)}function fg(n){wt.value="preview",Tn(n)}var Pc=.0015,Ic=class{constructor(e,t,i){this.record=e;this.scene=t;this.known=i}record;scene;known;get duration_s(){return this.record.duration_s}get stops(){return[...new Set([...this.record.skills.map(e=>e.starts_s),this.duration_s])]}sensedAt(e){let{start:t,moments:i,placings:s,placed:r}=this.record,o=new Map(Object.entries(t.robots)),a=new Map(Object.entries(t.pieces));for(let l of i){if(l.at_s>e+Pc)break;for(let h of l.gone)a.delete(h);for(let[h,f]of Object.entries(l.robots))o.set(h,f);for(let[h,f]of Object.entries(l.pieces))a.set(h,f)}let c=new Map(Object.entries(r));for(let{at_s:l,target:h,piece:f}of s){if(l>e+Pc)break;f===null?c.delete(h):c.set(h,f)}return{robots:o,pieces:a,placed:c}}skillsAt(e){return this.record.skills.filter(t=>t.starts_s<=e+Pc&&e<t.starts_s+t.duration_s-Pc)}pose(e,t,i){let s=this.sensedAt(e);this.putRobots(s,t);let r=wM(s,t);for(let o of this.skillsAt(e))this.play(o,e-o.starts_s,t);for(let[o,a]of s.pieces)i.setPose(o,Tt(a));for(let{robot:o,piece:a,tip_T_piece:c}of r)i.setPose(a,t.tipOf(o).multiply(c));return s}putRobots(e,t){for(let i of this.scene.end_effectors){let s=[...e.robots].find(([,o])=>o.mounted===i.id);t.attach(i.id,s?.[0]??null,this.record.docks[i.id]??null);let r=i.description.joints.filter(o=>o.kind!=="fixed").length;s!==void 0&&t.setTool(i.id,Array.from({length:r},()=>s[1].aperture_m/r))}for(let[i,s]of e.robots)t.setPosture(i,s.q_rad)}play(e,t,i){let s=this.stepOf(e),r=0;for(let o of s?.motions??[]){let a=this.known.trajectories.get(o.trajectory_sha256);if(a===void 0||t<r)return;if(i.setPosture(o.robot,Ac(a,t-r)),r+=o.duration_s,t>=r)for(let c of o.after)i.attach(c.body,c.on,c.pose)}}stepOf(e){return this.known.plans.get(e.fingerprint)?.steps.find(t=>t.number===e.step)}};function wM(n,e){return[...n.robots].flatMap(([t,{gripped:i}])=>{let s=i===null?void 0:n.pieces.get(i);return i===null||s===void 0?[]:[{robot:t,piece:i,tip_T_piece:e.tipOf(t).invert().multiply(Tt(s))}]})}var Ju=we(0),pg=new Map,mg=new Map,$u=new Set,ju=we(null);function Ku(n){ju.value=n}function gg(){let n=[Ze(()=>{let e=Qe.value;Dn.value=ju.value===null||e===null?null:new Ic(ju.value,e,{plans:pg,trajectories:mg})}),Ze(()=>{let e=Dn.value;if(e!==null)for(let{fingerprint:t}of e.skillsAt(qt.value))TM(t)})];return()=>n.forEach(e=>e())}async function TM(n){if(!$u.has(n)){$u.add(n);try{let e=await lt(Jt(`/api/proposals/${n}`)),t=[...new Set(e.steps.flatMap(i=>i.motions.map(s=>s.trajectory_sha256)))];await Promise.all(t.map(async i=>{mg.set(i,await Yu(i))})),pg.set(n,e),Ju.value+=1}catch{$u.delete(n)}}}function Qu(n){let e=n.filter(s=>s.layer==="target"||s.layer==="as_built"),t=new Map(e.map(s=>[s.id,s])),i=[];for(;t.size>0;){let s=[...t.values()].filter(o=>![...o.parents,...o.waits_for].some(a=>t.has(a))),r=(s.length>0?s:[...t.values()]).sort(EM)[0];if(r===void 0)break;i.push(r),t.delete(r.id)}return i}function EM(n,e){return+(e.layer==="as_built")-+(n.layer==="as_built")||(n.order??1/0)-(e.order??1/0)||n.id.localeCompare(e.id,"en",{numeric:!0})}function _g(n,e){return new Set(Qu(n).slice(0,e).map(t=>t.id))}function vg(){let n=Cc(),e=n?.duration_s??0;if(n===null){let i=xr.value!==""?A("preview.failed",{reason:xr.value}):et.value===null?A("preview.none"):A("preview.loading");return p("p",{class:"transport",role:"status",children:i})}let t=()=>{!pn.value&&qt.value>=e-.001&&Tn(0),pn.value=!pn.value};return p("div",{class:"transport",children:[p("button",{type:"button","aria-label":A("preview.start"),title:A("preview.start"),onClick:()=>Tn(0),children:p(Lc,{path:"M6 5v14M19 5 9 12l10 7Z"})}),p("button",{type:"button","aria-label":A("preview.back"),title:A("preview.back"),onClick:()=>Zu(-1),children:p(Lc,{path:"M16 5 6 12l10 7Z"})}),p("button",{type:"button",class:"play","aria-label":pn.value?A("preview.pause"):A("preview.play"),onClick:t,children:p(Lc,{path:pn.value?"M8 5v14M16 5v14":"M7 4l13 8-13 8Z"})}),p("button",{type:"button","aria-label":A("preview.next"),title:A("preview.next"),onClick:()=>Zu(1),children:p(Lc,{path:"M8 5l10 7-10 7Z"})}),p("input",{type:"range",min:0,max:e,step:.01,value:qt.value,"aria-label":A("preview.time"),"aria-valuetext":`${Dt(qt.value,1)} s`,onInput:i=>{pn.value=!1,Tn(i.currentTarget.valueAsNumber)}}),p("output",{children:[Dt(qt.value,1)," / ",Dt(e,1)," s"]})]})}function Lc({path:n}){return p("svg",{viewBox:"0 0 24 24",width:"22",height:"22",fill:"currentColor",stroke:"currentColor","stroke-width":"2","stroke-linejoin":"round","aria-hidden":"true",children:p("path",{d:n})})}var AM=["now","preview","target","as-built"],yg=we([]),Dc=we(""),Nc=we(null),wr=null,Ds=()=>wr;function xg(){let n=Lt(null),e=Lt(null);return gt(()=>{if(!(n.current===null||e.current===null))try{return NM(e.current,n.current)}catch(t){Dc.value=t instanceof Error?t.message:String(t);return}},[]),p("section",{class:`picture ${wt.value}`,children:[p("div",{class:"frame",ref:n,children:[p("canvas",{ref:e,role:"img","aria-label":A("picture.label")}),Dc.value===""&&yg.value.map(t=>p("span",{class:"plate","aria-hidden":"true",style:{transform:`translate(${t.x}px, ${t.y}px)`,background:ed()?We.stale:vc(t.number-1)},children:t.number},t.id)),Dc.value!==""&&p("p",{class:"fault",children:A("picture.failed",{reason:Dc.value})}),p(RM,{})]}),p(CM,{}),p(IM,{}),bg()&&p(vg,{})]})}var bg=()=>(wt.value==="preview"||wt.value==="replay")&&Xt.value!=="building",ed=()=>wt.value==="now"&&ct.value!=="live"&&!Fs;function RM(){return dc.value!==null&&wt.value==="now"&&Xt.value==="cell"?p("p",{class:"over tried-then",children:[A(dc.value.posture===null?"picture.blockers":"picture.refused"),p("button",{type:"button",onClick:()=>As.value=null,children:A("picture.back")})]}):bg()?p("p",{class:"over",children:A(wt.value==="replay"?"picture.replay":"picture.preview")}):Xt.value==="building"||!ed()||ct.value==="lost"||ct.value==="connecting"?null:p("p",{class:"over old",children:["◷ ",A("picture.stale",{seconds:Dt(Es.value,1)})]})}function CM(){return Xt.value!=="cell"?null:p("div",{class:"modes segmented",role:"group","aria-label":A("mode.label"),children:AM.map(n=>p("button",{type:"button","aria-pressed":wt.value===n,onClick:()=>PM(n),children:A(`mode.${n}`)},n))})}function PM(n){pn.value=!1,wt.value=n}function IM(){let n=Qe.value?.robots??[],[e,t]=Xe(!1);return p("div",{class:"views",children:[p("button",{type:"button",class:"opener","aria-expanded":e,onClick:()=>t(!e),children:[A("view.open")," ",p("span",{"aria-hidden":"true",children:"▾"})]}),e&&p(LM,{robots:n,onChosen:()=>t(!1)})]})}function LM({robots:n,onChosen:e}){let t=i=>{i(),e()};return p("div",{class:"menu",role:"group","aria-label":A("view.label"),children:[["whole","top","front","side"].map(i=>p("button",{type:"button",onClick:()=>t(()=>wr?.look(i)),children:A(`view.${i}`)},i)),n.map(i=>p("button",{type:"button",onClick:()=>t(()=>wr?.lookFromRobot(i.id)),children:A("view.robot",{number:i.number})},i.id)),n.map(i=>p("button",{type:"button","aria-pressed":Nc.value===i.id,onClick:()=>t(()=>DM(i.id)),children:A("view.follow",{number:i.number})},i.id))]})}function DM(n){Nc.value=Nc.value===n?null:n,wr?.follow(Nc.value)}function NM(n,e){let t=new Ec(n,e,hf);wr=t,t.onPick=s=>{s!==null&&yr.peek().has(s)||(fn.value=s)},t.onGround=(s,r)=>{Ri.peek()&&(Cs.value=[s,r,Ps.peek()[2]/2])},t.stage.onDrawn=()=>{yg.value=t.tags(),uf(t.stage.cost),Qe.peek()!==null&&ia("first")};let i=[Ze(()=>{Qe.value!==null&&t.setScene(Qe.value)}),Ze(()=>{Do.value!==null&&!Fs&&t.setJoints(Do.value)}),Ze(()=>OM(t)),Ze(()=>t.setStale(ed())),Ze(()=>t.setMode(Xt.value==="building"?"target":wt.value)),UM(t),Ze(()=>FM(t)),Ze(()=>t.setLit(BM())),Ze(()=>t.setLitThings(new Set(No.value))),Ze(()=>{Qe.value,t.setRefused(dc.value)}),Ze(()=>t.setRehearsal(ai.value)),Ze(()=>t.setReplay(Dn.value)),Ze(()=>{ai.value,Qe.value,t.setStep(Ye.value?.phase==="running"&&wt.value==="now"?null:Ru.value)}),Ze(()=>{Ju.value,t.setTime(qt.value)}),Ze(()=>t.setDraft(Ri.value?{centre:Cs.value,size:Ps.value}:null)),ug(t),gg(),dg()];return()=>{for(let s of i)s();t.dispose(),wr=null}}function UM(n){let e=!1;return Ze(()=>{let t=Xt.value==="building";Qe.value!==null&&t!==e&&(e=t,n.lookAtBuilding(t))})}function OM(n){let e=uc.value,t=Qe.value?.components??[];if(e===null||Fs)return;let i=new Map([...gm(e)].flatMap(([s,r])=>t[s]===void 0?[]:[[t[s].id,r]]));n.setSensedPoses(i)}function FM(n){let e=ts.value,t=Qe.value?.components??[],i=wt.value==="replay"?new Set:new Set(t.filter(r=>r.layer==="as_built").map(r=>r.made_of)),s=Xt.value==="building"&&ns.value!==null?_g(t,ns.value):null;n.setFilter(r=>!e.has(r.id)&&!i.has(r.id)&&(s===null||r.layer==="virtual_collision"||s.has(r.id)))}function BM(){let n=new Map(No.value.map(i=>[i,We.blocker])),e=Ru.value,t=e===null||wt.value==="replay"||Ye.value?.phase==="finished"?[]:[...e.arguments,e.holds_before?.piece,e.holds_after?.piece];for(let i of t)i!==void 0&&!n.has(i)&&n.set(i,We.selected);return fn.value!==null&&n.set(fn.value,We.selected),n}function Sg(){let n=Oo.value;return n===null?null:p(kM,{give:n.give})}function kM({give:n}){let[e,t]=Xe(""),[i,s]=Xe(""),r=o=>{o.preventDefault(),n({by:e,pin:i})};return p(Wn,{title:A("pin.title"),onClose:()=>n(null),isBeside:!0,children:p("form",{onSubmit:r,children:[p("label",{class:"field",children:[A("sign-in.user"),p("select",{required:!0,value:e,onChange:o=>t(o.currentTarget.value),children:[p("option",{value:""}),dn.value?.people?.map(o=>p("option",{children:o},o))]})]}),p("label",{class:"field",children:[A("pin.pin"),p("input",{type:"password",inputMode:"numeric",pattern:"[0-9]{4,12}",autocomplete:"off",required:!0,value:i,onInput:o=>s(o.currentTarget.value)})]}),p("footer",{children:[p("button",{type:"button",onClick:()=>n(null),children:A("act.cancel")}),p("button",{type:"submit",disabled:!ht.value,children:A("act.send")})]})]})})}var zM="0123456789ABCDEFGHJKMNPQRSTVWXYZ";function Mg(n){let e=BigInt(`0x${n.slice(0,10)}`),t="";for(let i=0;i<8;i+=1)t=(zM[Number(e&31n)]??"")+t,e>>=5n;return`${t.slice(0,4)}-${t.slice(4)}`}function GM(n){let e=n.detail.approval?.scope,t=n.words===""?sn("verb",n.verb):n.words;return e===void 0?t:`${t}: ${A(`scope.${e.kind}`,{step:e.step})}`}function VM(n){let e=n.detail,t=e.fingerprint??e.approval?.fingerprint??"";return t===""?"":Mg(t)}function wg(n){let[e,t]=Xe(null),[i,s]=Xe("");return gt(()=>{let r=()=>lt(n).then(a=>(t(a),s("")),a=>s(a.message));r();let o=setInterval(()=>{r()},2e3);return()=>clearInterval(o)},[n]),[e,i]}function Tg(){let[n,e]=wg(Jt("/api/audit"));return p("div",{class:"sheet scroll",tabIndex:0,role:"region","aria-label":A("nav.audit"),children:[p("h2",{children:A("audit.title")}),e!==""&&p("p",{role:"alert",children:A("failed",{reason:e})}),n?.entries.length===0&&p("p",{children:A("audit.none")}),n!==null&&n.entries.length>0&&p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:A("audit.when")}),p("th",{scope:"col",children:A("audit.who")}),p("th",{scope:"col",children:A("audit.what")}),p("th",{scope:"col",children:A("audit.code")})]})}),p("tbody",{children:n.entries.map(t=>p("tr",{children:[p("td",{children:p("time",{children:ds(t.at_ms)})}),p("td",{children:[t.who," ",p("span",{class:"soft",children:t.role})]}),p("td",{children:[GM(t),(t.shown??[]).length>0&&p("details",{children:[p("summary",{children:A("audit.seen")}),p("ol",{class:"seen",children:t.shown.map((i,s)=>p("li",{children:i},s))})]})]}),p("td",{children:p("code",{children:VM(t)})})]},`${t.run} ${t.n}`))})]})]})}function Eg(){let[n,e]=wg("/api/health");return p("div",{class:"sheet scroll",tabIndex:0,role:"region","aria-label":A("nav.health"),children:[p("h2",{children:A("health.title")}),e!==""&&p("p",{role:"alert",children:A("failed",{reason:e})}),n!==null&&e===""&&p("dl",{class:"health",children:[p(Tr,{name:A("health.server"),isGood:!0,words:`${n.server.version}, ${A("health.uptime",{seconds:Dt(n.server.uptime_s)})}, ${us("health.clients",n.server.clients)}`}),p(Tr,{name:A("health.run"),isGood:n.run.is_alive,words:`${sn("phase",n.run.phase)}, ${n.run.is_alive?A("health.alive"):A("health.dead")}`}),p(Tr,{name:A("health.cell"),isGood:n.cell.state==="live",words:HM(n.cell)}),p(Tr,{name:A("health.journal"),isGood:n.journal.is_whole!==!1,words:WM(n.journal)}),p(Tr,{name:A("health.disk"),isGood:n.disk_free_bytes>1e9,words:`${Dt(n.disk_free_bytes/1e9,1)} GB`}),p(Tr,{name:A("health.page"),isGood:!0,words:A("health.frame",{ms:Dt(window.__m.cost.js_ms,1),calls:window.__m.cost.calls})})]})]})}function HM({state:n,age_ms:e}){return e===null||n==="absent"?A("link.absent"):n==="live"?`${A("link.live")}, ${Ni(e/1e3)}`:A("link.stale",{seconds:Dt(e/1e3)})}function WM({run:n,n:e,is_whole:t}){let i=`${n} #${e}`;return t===void 0?i:`${i}, ${t?A("health.whole"):A("health.not-whole")}`}function Tr({name:n,words:e,isGood:t}){return p("div",{class:t?"good":"bad",children:[p("dt",{children:n}),p("dd",{children:[p("span",{"aria-hidden":"true",children:t?"✓":"!"})," ",e]})]})}function Ag(){let n=fn.value,e=Qe.value?.components.find(o=>o.id===n),[t,i]=Xe(!1);if(e===void 0)return null;let s=e.operations.filter(o=>o.done).length,r=[[A("card.layer"),A(`layer.${e.layer}`)],[A("card.state"),sn("state",e.status)],[A("card.type"),e.type],[A("card.material"),e.material],[A("card.parents"),e.parents.map(td).join(", ")],[A("card.waits"),e.waits_for.map(td).join(", ")],[A("card.made"),e.made_of===null?"":td(e.made_of)],[A("card.place"),e.stack??""],[A("card.operations"),e.operations.length===0?"":A("card.operations.done",{done:s,count:e.operations.length})]];return p("section",{class:"card","aria-label":A("card.label"),children:[p("header",{children:[p("h2",{children:e.name}),p("button",{type:"button",class:"quiet","aria-label":A("card.close"),onClick:()=>fn.value=null,children:"✕"})]}),p("dl",{children:r.filter(([,o])=>o!=="").map(([o,a])=>p("div",{children:[p("dt",{children:o}),p("dd",{children:a})]},o))}),e.note!==""&&p("p",{class:"soft",children:e.note}),e.deviation!==null&&p("p",{class:"soft",children:e.deviation.words}),en("mismatch")&&p("button",{type:"button",disabled:!ht.value,onClick:()=>i(!0),children:A("card.mismatch")}),t&&p(XM,{id:e.id,name:e.name,onClose:()=>i(!1)})]})}var td=n=>n==="jobsite"?A("building.jobsite"):mm(n);function XM({id:n,name:e,onClose:t}){let[i,s]=Xe(""),[r]=Xe(et.value?.fingerprint??""),o=a=>{a.preventDefault(),t(),Ot({fingerprint:r,verb:"mismatch",component:n,detail:i})};return p(Wn,{title:A("mismatch.title",{name:e}),onClose:t,children:p("form",{onSubmit:o,children:[p("p",{children:A("mismatch.text")}),p("label",{class:"field",children:[A("mismatch.detail"),p("input",{type:"text",value:i,maxLength:300,onInput:a=>s(a.currentTarget.value)})]}),p("footer",{children:[p("button",{type:"button",onClick:t,children:A("act.cancel")}),p("button",{type:"submit",class:"warn",disabled:!ht.value,children:A("card.mismatch")})]})]})})}var Rg="http://www.w3.org/2000/svg",qM=new Set(["svg","g","rect","line","circle","path","text","title"]),YM=new Set(["viewBox","width","height","x","y","x1","x2","y1","y2","cx","cy","r","rx","d","class","role","fill","fill-opacity","opacity","stroke","stroke-width","font-family","font-size","font-weight","text-anchor"]);function ZM(n){let e=new DOMParser().parseFromString(n,"image/svg+xml").documentElement;return Cg(e)}function Cg(n){if(n.namespaceURI!==Rg||!qM.has(n.localName))throw new Error(`a picture has no <${n.localName}>`);let e=document.createElementNS(Rg,n.localName);for(let{name:t,value:i}of n.attributes)if(t!=="xmlns"){if(!YM.has(t)&&!t.startsWith("data-"))throw new Error(`a picture has no attribute ${t}`);e.setAttribute(t,i)}for(let t of n.childNodes)e.append(t instanceof Element?Cg(t):document.createTextNode(t.textContent??""));return e}function Uc({path:n,revision:e=0,items:t,isSelected:i,onPick:s,onDrawn:r,kind:o,label:a}){let c=Lt(null),[l,h]=Xe(null);Ns(()=>{let _=n!==null;return n!==null&&of(n).then(b=>{_&&h(ZM(b))},()=>{}),()=>{_=!1}},[n,e]),Ns(()=>{c.current?.replaceChildren(...l===null||n===null?[]:[l])},[l,n===null]),Ns(()=>{if(l!==null){for(let _ of t(l))_.classList.add("pick"),_.classList.toggle("selected",i(_));r?.(l)}});let f=_=>{_!==void 0&&s(_)};return p("div",{class:o,ref:c,role:"group","aria-label":a,tabIndex:0,onClick:_=>f(_.target.closest(".pick")??void 0),onKeyDown:_=>{let b=_.key==="ArrowRight"?1:_.key==="ArrowLeft"?-1:0,m=l===null?[]:t(l);if(b===0||m.length===0)return;_.preventDefault();let g=b>0?m.map(i).lastIndexOf(!0):m.findIndex(i),S=m[Math.min(Math.max(g+b,0),m.length-1)];S?.scrollIntoView({block:"nearest",inline:"nearest"}),f(S)}})}var Pg=16;function Ig(){let[n,e]=KM(),{path:t,at_s:i,kinds:s,isSelected:r,choose:o}=$M();return p("div",{class:"strip",ref:n,children:p(Uc,{kind:"gantt",label:A("gantt.label"),path:t===null||e===0?null:`${Jt(t)}&width=${e}`,revision:mc.value,items:a=>[...a.querySelectorAll(s)].sort((c,l)=>Fc(c)-Fc(l)||Oc(c)-Oc(l)),isSelected:r,onPick:o,onDrawn:a=>JM(a,i)})})}function $M(){let n=Dn.value,e=wt.value==="preview"||n!==null?qt.value:null;if(n!==null){let s=new Set(n.skillsAt(qt.value).map(r=>r.starts_s.toFixed(3)));return{path:`/api/runs/${n.record.run}/schedule.svg`,at_s:e,kinds:".actual",isSelected:r=>s.has(r.dataset.startsS??""),choose:r=>Tn(Fc(r))}}let t=et.value;if(t!==null){let s=Ct.value;return{path:`/api/proposals/${t.fingerprint}/schedule.svg`,at_s:e,kinds:"[data-step]",isSelected:r=>Oc(r)===s,choose:jM}}let i=Ye.value?.run??"";return{path:i===""?null:`/api/runs/${i}/schedule.svg`,at_s:null,kinds:".actual",isSelected:()=>!1,choose:()=>{}}}var Oc=n=>Number(n.dataset.step),Fc=n=>Number(n.dataset.startsS);function jM(n){br(Oc(n)),wt.value==="preview"&&Tn(Fc(n))}function JM(n,e){n.querySelector(".moment")?.remove();let{left:t,right:i,endS:s}=n.dataset;if(e===null||t===void 0||i===void 0||s===void 0)return;let r=Number(t)+(Number(i)-Number(t))*Math.min(e,Number(s))/Number(s),o=document.createElementNS(n.namespaceURI,"line");for(let[a,c]of Object.entries({class:"moment",x1:r,x2:r,y1:0,y2:n.viewBox.baseVal.height-14}))o.setAttribute(a,String(c));n.append(o)}function KM(){let n=Lt(null),[e,t]=Xe(0);return gt(()=>{if(n.current===null)return;let i=new ResizeObserver(([s])=>t(Math.floor((s?.contentRect.width??0)/Pg)*Pg));return i.observe(n.current),()=>i.disconnect()},[]),[n,e]}function Lg(){let n=Ye.value,e=n?.trouble??[],t=e.flatMap(i=>[...i.pair??[],...i.blockers]).map(i=>i.split("/")[0]??i);return gt(()=>{No.value=[...new Set(t)]},[t.join(" ")]),n===null||n.question===null&&e.length===0?null:p("section",{class:"help","aria-label":A("help.title"),children:[n.question!==null&&p(QM,{question:n.question}),e.map(i=>p(ew,{trouble:i},i.target))]})}function QM({question:n}){return p("div",{class:"trouble",children:[p("h2",{children:A("question.title")}),p("p",{children:n.text}),p("div",{class:"buttons",children:n.answers.map(e=>p("button",{type:"button",disabled:!ht.value||!en("answer"),onClick:()=>{Ot({fingerprint:"",verb:"answer",question_id:n.question_id,answer:e})},children:sn("answer",e)},e))})]})}function ew({trouble:n}){let[e,t]=Xe(!1),[i,s]=n.pair_names;return p("div",{class:"trouble",children:[p("h2",{children:[A("help.title"),": ",n.name]}),p("p",{children:n.reason}),n.rejected.map(r=>p("p",{children:r},r)),n.verdict!==""&&p("p",{class:"verdict",children:[p("b",{children:n.verdict})," ",sn("verdict",n.verdict_kind)]}),i!==void 0&&s!==void 0&&p("p",{class:"pair",children:A("help.pair",{first:i,second:s})}),n.counter_proposals.length>0&&p(tw,{tried:n.counter_proposals}),p("div",{class:"buttons",children:[(n.pair??n.blockers).length>0&&p("button",{type:"button",class:"show","aria-pressed":As.value===n.target,onClick:()=>nw(n),children:A("help.show")}),n.options.map(r=>p(iw,{option:r,onManual:()=>t(!0)},r.id))]}),n.options.length===0&&p("p",{class:"soft",children:A("help.none")}),e&&p(sw,{target:n.target,name:n.name,onClose:()=>t(!1)})]})}function tw({tried:n}){return p(kt,{children:[p("p",{class:"soft",children:A("help.tried")}),p("ul",{class:"tried",children:n.map(({words:e,steps:t,duration_s:i})=>p("li",{children:A("help.tried-one",{words:e,steps:t,seconds:Dt(i)})},e))})]})}function nw(n){wt.value="now",As.value=As.value===n.target?null:n.target,document.querySelector(".picture")?.scrollIntoView({block:"nearest"})}function iw({option:n,onManual:e}){let t=et.value?.fingerprint??"",{verb:i,zone:s}=n,r=()=>{i==="manual"?e():i==="zone"&&s===void 0?Ri.value=!0:Ot({fingerprint:t,verb:i,...s&&{zone:s}})};return p("button",{type:"button",disabled:!ht.value||!en(i),onClick:r,children:n.words})}function sw({target:n,name:e,onClose:t}){let[i,s]=Xe([]),[r,o]=Xe(new Set),[a,c]=Xe("");gt(()=>{lt(Jt(`/api/manual/${n}`)).then(f=>s(f.effects),f=>c(f.message))},[n]);let l=f=>{let d=new Set(r);d.delete(f)||d.add(f),o(d)},h=f=>{f.preventDefault(),t(),Ot({fingerprint:et.value?.fingerprint??"",verb:"manual",target:n,effects:[...r]})};return p(Wn,{title:A("manual.title",{name:e}),onClose:t,children:p("form",{onSubmit:h,children:[p("p",{children:A("manual.text")}),a!==""&&p("p",{role:"alert",children:A("failed",{reason:a})}),p("fieldset",{class:"choices",children:i.map(f=>p("label",{children:[p("input",{type:"checkbox",checked:r.has(f.fact),onChange:()=>l(f.fact)}),f.words]},f.fact))}),p("footer",{children:[p("button",{type:"button",onClick:t,children:A("act.cancel")}),p("button",{type:"submit",class:"warn",disabled:r.size===0||!ht.value,children:A("act.send")})]})]})})}function Dg(){let n=Lt(null),e=ei.value;return gt(()=>{e!==null&&e.kind!=="recorded"&&n.current?.scrollIntoView({block:"nearest"})},[e]),e===null?null:p("div",{ref:n,class:e.kind==="refused"?"stays":"",children:p(rw,{last:e})})}function rw({last:n}){if(n.kind==="recorded")return p("p",{class:"result good",role:"status",children:n.words});if(n.kind==="refused")return p("p",{class:"result bad",role:"alert",children:n.words});if(n.kind==="unknown")return p("div",{class:"result bad",role:"alert",children:[p("p",{children:A("done.unknown")}),p("button",{type:"button",onClick:()=>{n.again()},children:A("act.again")})]});let{refusal:e}=n;return p("div",{class:"result bad",role:"alert",children:[p("p",{children:[p("b",{children:[A("stale.title"),"."]})," ",e.message]}),p("p",{children:e.open==null?A("stale.none"):A("stale.open",{code:e.open.code})}),(e.changed??[]).length>0&&p("ul",{children:e.changed?.map((t,i)=>p("li",{children:t.words},i))})]})}function Ng({plan:n}){return p("ol",{class:"steps","aria-label":A("plan.list"),children:n.steps.map(e=>p(ow,{step:e,plan:n},`${n.fingerprint} ${e.number}`))})}function ow({step:n,plan:e}){let t=Ct.value===n.number,i=Lt(null),s=Ye.value?.running?.step===n.number&&Ye.value.running.fingerprint===e.fingerprint;gt(()=>{(t||s)&&i.current?.scrollIntoView({block:"nearest"})},[t,s]);let r=s?"running":n.is_done?"done":n.status,o=n.flags.length>0&&!n.is_done;return p("li",{ref:i,class:`step ${r.replace(" ","-")} ${t?"selected":""} ${o?"flagged":""}`,"data-step":n.number,children:[p("button",{type:"button",class:"row","aria-expanded":t,onClick:()=>br(t?null:n.number),children:[p("span",{class:"number",children:n.number}),p(aw,{robot:n.robot}),p("span",{class:"words",children:[n.robot_name," ",n.words,n.why!==""&&p("small",{children:n.why}),o&&p("small",{class:"flag",children:["⚠ ",n.flags.join(" ")," ",es.value.has(n.number)?A("step.seen"):A("step.look")]})]}),p("span",{class:"figures",children:[r==="open"?Ni(n.duration_s):sn("step",r),n.closest_distance_m!==null&&p("small",{children:A("step.distance",{distance:Ur(n.closest_distance_m)})})]})]}),t&&p(lw,{step:n,plan:e})]})}function aw({robot:n}){let e=pm(n);return p("span",{class:"robot",style:{background:vc(e-1)},title:n,children:[p("span",{class:"unseen",children:A("step.robot",{number:e})}),p("span",{"aria-hidden":"true",children:e})]})}function lw({step:n,plan:e}){let[t,i]=Xe(null),s=async()=>{let c=Jt(`/api/proposals/${e.fingerprint}/steps/${n.number}/why`),l=await lt(c).catch(h=>({lines:[A("failed",{reason:h.message})]}));i(l.lines)},[r,o]=n.closest_names,a=n.motions.length>0&&!n.is_done&&en("new-motion");return p("div",{class:"details",children:[p("p",{class:"soft",children:n.motions.length===0||n.closest_distance_m===null||r===void 0||o===void 0?A("step.still"):A("step.closest",{distance:Ur(n.closest_distance_m),first:r,second:o})}),p("div",{class:"buttons",children:[p("button",{type:"button",onClick:()=>fg(n.starts_s),children:A("step.play")}),p("button",{type:"button",onClick:()=>{s()},children:A("step.why")}),a&&Ye.value?.phase==="waiting"&&p("button",{type:"button",disabled:!ht.value,onClick:()=>{Ot({fingerprint:e.fingerprint,verb:"new-motion",step:n.number})},children:A("step.motion")})]}),t!==null&&p("div",{class:"because",role:"status",children:t.map((c,l)=>p("p",{class:c.startsWith(" ")?"inner":"",children:c.trim()},l))})]})}function Ug(){let n=et.value;return p("div",{class:"plan",children:[p(Lg,{}),p(Dg,{}),n!==null?p(hw,{plan:n}):cw()?null:p(pw,{})]})}var cw=()=>Ye.value?.question!=null||(Ye.value?.trouble??[]).length>0;function hw({plan:n}){return p(kt,{children:[p("header",{class:"plan-head",children:[p("div",{children:[p("h2",{children:n.title}),n.why!==""&&p("p",{class:"why",children:n.why})]}),p("dl",{children:[p(nd,{name:A("plan.code"),value:p("code",{class:"code",children:n.code})}),p(nd,{name:A("plan.duration"),value:Ni(n.duration_s)}),n.closest_distance_m!==null&&p(nd,{name:A("plan.closest"),value:`${Ur(n.closest_distance_m)} mm`})]})]}),p(dw,{plan:n}),p(fw,{plan:n}),p(Ng,{plan:n})]})}function nd({name:n,value:e}){return p("div",{children:[p("dt",{children:n}),p("dd",{children:e})]})}var uw={target:"→",removed:"−",added:"+",motion:"~"};function dw({plan:n}){let e=Lt(null),t=ei.value?.kind==="stale";gt(()=>{let o=e.current;if(o===null)return;t&&o.focus();let a=new IntersectionObserver(c=>{c.some(l=>l.isIntersecting)&&Em(n.fingerprint)},{threshold:.25});return a.observe(o),()=>a.disconnect()},[n.fingerprint,t,n.differences.length]);let{previous_code:i}=n;if(n.differences.length===0)return null;let s=n.differences.filter(o=>o.kind==="target"),r=s.length>0?s:n.differences;return p("section",{class:"differences",ref:e,tabIndex:-1,"aria-label":A("plan.changed.none"),children:[p("h3",{children:i===""?A("plan.changed.none"):A("plan.changed",{code:i})}),p("ul",{tabIndex:0,children:r.map((o,a)=>p("li",{class:o.kind,children:[p("span",{"aria-hidden":"true",children:uw[o.kind]})," ",o.step!==void 0&&`${o.step}. `,o.words]},a))})]})}function fw({plan:n}){return p("details",{class:"summary",children:[p("summary",{children:[A("plan.short")," ",p("span",{class:"soft",children:us("plan.steps",n.steps.length)})]}),p("ul",{children:n.summary.map(e=>p("li",{children:e},e))}),n.notes.length>0&&p(kt,{children:[p("h3",{children:A("plan.notes")}),p("ul",{class:"soft",children:n.notes.map(e=>p("li",{children:e},e))})]})]})}function pw(){let n=Ye.value?.phase??"other",e=["idle","planning","running","held","finished"].includes(n)?n:"other",t=Qi.value?.open===null?Qi.value.reason:"";return p("div",{class:"empty",children:[p("h2",{children:A(`phase.${Ye.value?.phase??"idle"}`)}),p("p",{children:A(`plan.none.${e}`)}),(Ye.value?.held?.reason??t)!==""&&p("p",{class:"soft",children:Ye.value?.held?.reason??t}),n==="finished"&&Ye.value!==null&&p("p",{children:p("a",{class:"button",href:`/api/runs/${Ye.value.run}/report`,target:"_blank",rel:"noreferrer",children:A("runs.report")})})]})}var mw=["target","as_built","material","virtual_collision","as_designed"];function Og(){let[n,e]=Xe(""),t=(Qe.value?.components??[]).filter(i=>`${i.name} ${i.id} ${i.type}`.toLowerCase().includes(n.toLowerCase()));return p("div",{class:"tree",children:[p("label",{class:"field",children:[p("span",{class:"unseen",children:A("tree.search")}),p("input",{type:"search",placeholder:A("tree.search"),value:n,onInput:i=>e(i.currentTarget.value)})]}),p("div",{"aria-label":A("tree.list"),role:"group",children:[mw.map(i=>p(_w,{layer:i,members:t.filter(s=>s.layer===i)},i)),p(gw,{})]})]})}function gw(){let n=Qe.value?.zones??[];return n.length===0?null:p("details",{class:"layer",open:!0,children:[p("summary",{children:[p("span",{class:"swatch virtual_collision","aria-hidden":"true"}),A("tree.zones")," ",p("span",{class:"soft",children:n.length})]}),p("ul",{children:n.map(e=>p("li",{children:[p("span",{class:"name zone",children:e.name}),e.by!=="cell"&&en("zone")&&p("button",{type:"button",disabled:!ht.value,onClick:()=>{Ot({fingerprint:"",verb:"zone",zone:{remove:e.id}})},children:A("zone.remove")})]},e.id))})]})}function _w({layer:n,members:e}){if(e.length===0)return null;let t=A(`layer.${n}`),i=e.some(s=>!ts.value.has(s.id));return p("details",{class:"layer",open:e.length<60,children:[p("summary",{children:[p("span",{class:`swatch ${n}`,"aria-hidden":"true"}),t," ",p("span",{class:"soft",children:e.length})]}),p(id,{words:A("tree.show",{name:t}),isOn:i,sign:"eye",onToggle:()=>sd(ts,e,i)}),p("ul",{children:e.map(s=>p(vw,{component:s},s.id))})]})}function vw({component:n}){let{id:e,name:t}=n;return p("li",{class:fn.value===e?"selected":"",children:[p("button",{type:"button",class:"name","aria-pressed":fn.value===e,onClick:()=>fn.value=e,children:[t,p("small",{children:[sn("state",n.status),n.accessible&&` · ${A("card.accessible")}`]})]}),p(id,{words:A("tree.show",{name:t}),isOn:!ts.value.has(e),sign:"eye",onToggle:()=>sd(ts,[n],!ts.value.has(e))}),p(id,{words:A("tree.lock",{name:t}),isOn:yr.value.has(e),sign:"lock",onToggle:()=>sd(yr,[n],!yr.value.has(e))})]})}function id({words:n,isOn:e,sign:t,onToggle:i}){return p("button",{type:"button",class:"toggle","aria-pressed":e,"aria-label":n,title:n,onClick:i,children:t==="eye"?p(yw,{isOpen:e}):p(xw,{isShut:e})})}function yw({isOpen:n}){return p("svg",{viewBox:"0 0 24 24",width:"22",height:"22",fill:"none",stroke:"currentColor","stroke-width":"1.8","aria-hidden":"true",children:[p("path",{d:"M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12Z"}),n?p("circle",{cx:"12",cy:"12",r:"2.8"}):p("path",{d:"M4 20 20 4"})]})}function xw({isShut:n}){return p("svg",{viewBox:"0 0 24 24",width:"22",height:"22",fill:"none",stroke:"currentColor","stroke-width":"1.8","aria-hidden":"true",children:[p("rect",{x:"5",y:"11",width:"14",height:"9",rx:"2"}),p("path",{d:n?"M8 11V8a4 4 0 0 1 8 0v3":"M8 11V7a4 4 0 0 1 7.5-2"})]})}function sd(n,e,t){let i=new Set(n.value);for(let{id:s}of e)t?i.add(s):i.delete(s);n.value=i}function Fg(){let n=Qe.value?.components??[],e=Qu(n),t=e.filter(s=>s.layer==="as_built").length;Ns(()=>(ns.value=null,()=>{ns.value=null}),[]);let i=ns.value??e.length;return p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":A("nav.building"),children:[p("section",{class:"block",children:[p("h2",{children:A("building.order")}),p("input",{type:"range",min:0,max:e.length,value:i,"aria-label":A("building.slider"),onInput:s=>ns.value=s.currentTarget.valueAsNumber}),p("p",{class:"soft",children:A("building.shown",{count:i,total:e.length})}),p("ol",{class:"order",children:e.map((s,r)=>p("li",{class:r<i?"":"later",children:p("button",{type:"button","aria-pressed":fn.value===s.id,onClick:()=>fn.value=s.id,children:[p("span",{class:"number",children:r+1}),s.name,p("small",{children:r<t?sn("state","installed"):sn("state",s.status)})]})},s.id))})]}),p("section",{class:"block",children:[p("h2",{children:A("building.graph")}),p(bw,{})]})]})}function bw(){let n=fn.value;return p(Uc,{kind:"graph",label:A("building.graph.label"),path:Jt("/api/graph.svg"),revision:Qe.value?.epoch??0,items:e=>[...e.querySelectorAll("[data-component]")],isSelected:e=>e.dataset.component===n,onPick:e=>fn.value=e.dataset.component??null})}var Bc=we(null),Er=we(null),kg=we(0),kc=we("");function zg(){return gt(()=>(lt("/api/runs").then(n=>Bc.value=n.runs,Bg),()=>{pn.value=!1,Ku(null),Er.value=null,wt.value="now",Tn(0)}),[]),p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":A("runs.title"),children:[p("section",{class:"block",children:[p("h2",{children:A("runs.title")}),kc.value!==""&&p("p",{role:"alert",children:A("failed",{reason:kc.value})}),Bc.value===null&&kc.value===""&&p("p",{role:"status",children:A("loading")}),Bc.value?.length===0&&p("p",{children:A("runs.none")}),p("ul",{class:"run-list",children:Bc.value?.map(n=>p("li",{class:Er.value?.id===n.id?"selected":"",children:[p("button",{type:"button",onClick:()=>{ww(n.id).catch(Bg)},children:[p("b",{children:n.id})," ",sn("runs",n.ended),p("small",{children:[ds(n.started_at_ms)," · ",A("runs.installed",{installed:n.installed,targets:n.targets})]})]}),n.ended!=="open"&&p("a",{class:"button",href:`/api/runs/${n.id}/report`,target:"_blank",rel:"noreferrer",children:A("runs.report")})]},n.id))})]}),Er.value===null?p("p",{class:"block soft",children:A("runs.choose")}):p(Sw,{events:Er.value.events})]})}function Sw({events:n}){let e=Mw(),t=Lt(null);return gt(()=>t.current?.querySelector(".selected")?.scrollIntoView({block:"nearest"}),[e]),p("section",{class:"block",children:[p("h2",{children:A("runs.events")}),p("ol",{class:"journal",ref:t,children:n.map(i=>i.words!==""&&p("li",{"data-event":i.n,class:i.n===e?"selected":"",children:p("button",{type:"button","aria-current":i.n===e?"true":void 0,onClick:()=>Tw(i),children:[p("time",{children:ds(i.at_ms)}),i.words]})},i.n))})]})}function Mw(){let n=Dn.value?.record.events??[],e=new Set(Er.value?.events.filter(r=>r.words!=="").map(r=>r.n)),t=n.filter(r=>r.at_s<=qt.value+1e-6&&e.has(r.n)),i=t.at(-1),s=t.find(r=>r.n===kg.value);return(s?.at_s===i?.at_s?s?.n:i?.n)??0}async function ww(n){let[e,t]=await Promise.all([lt(Jt(`/api/runs/${n}`)),lt(`/api/runs/${n}/replay`)]);Er.value={id:n,events:e.events},Ku(t),wt.value="replay",Tn(0)}function Tw(n){pn.value=!1,kg.value=n.n,Tn(Dn.value?.record.events.find(e=>e.n===n.n)?.at_s??0)}function Bg(n){kc.value=n.message}var Ew=["plan","tree","journal"],rd={plan:"plan.title",tree:"tree.title",journal:"journal.title"};function Gg(){let n=Xt.value;return p("div",{class:`workspace ${n}`,children:[p("div",{class:"scene",children:[p(xg,{}),p(Ag,{}),n!=="building"&&p(Ig,{})]}),p("aside",{class:"side","aria-label":n==="cell"?A(rd[Qn.value]):A(`nav.${n}`),children:[n==="cell"&&p(Aw,{}),n==="building"&&p(Fg,{}),n==="runs"&&p(zg,{})]})]})}function Aw(){return p(kt,{children:[p("div",{class:"segmented tabs",role:"group",children:Ew.map(n=>p("button",{type:"button","aria-pressed":Qn.value===n,onClick:()=>Qn.value=n,children:A(rd[n])},n))}),p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":A(rd[Qn.value]),children:[Qn.value==="plan"&&p(Ug,{}),Qn.value==="tree"&&p(Og,{}),Qn.value==="journal"&&p(Rw,{})]})]})}function Rw(){let n=Ai.value.filter(e=>e.words!=="").reverse();return n.length===0?p("p",{class:"empty",children:A("journal.none")}):p("ol",{class:"journal",children:n.map(e=>p("li",{children:[p("time",{children:ds(e.at_ms)}),e.words]},`${e.run} ${e.n}`))})}function Cw(){let n=Xt.value;return p("div",{class:`page ${ct.value}`,children:[p(Um,{}),p(km,{}),p(Bm,{}),p("main",{children:p(Bo,{children:Pw(n)})}),p(Bo,{children:p(Om,{})}),p("footer",{class:"safety",children:A("safety")}),p(Im,{}),p(Sg,{})]})}function Pw(n){return n==="audit"?p(Tg,{}):n==="health"?p(Eg,{}):dn.value===null?null:p(Gg,{})}window.__app={project:n=>Ds()?.project(n)??null,placeOf:n=>Ds()?.placeOf(n)??null,postures:()=>Ds()?.postures()??[],tried:()=>({lit:Ds()?.shownRefused?.names??[],q_rad:Ds()?.shownRefused?.postures??{}}),pixels:()=>Ds()?.stage.pixels()??"",trajectories:()=>ai.value?.hashes??[]};var Vg=document.getElementById("page");if(Vg===null)throw new Error("index.html has no element with the id page");Tm(()=>performance.now());Cd(p(Cw,{}),Vg);ym().then(()=>ia("ui"),()=>{ct.value="lost",setTimeout(()=>location.reload(),2e3)});
